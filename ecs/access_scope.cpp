#include "ecs/access_scope.h"

#include <string>

#include "ecs/misuse.h"

namespace rambla::ecs::detail {

void AccessScope::require(const AccessPart& part) const {
    if (access_->covers(part.kind, part.type_index, part.writes)) return;
    throw_undeclared(system_, std::string{part.writes ? "writes " : "reads "}
                                  .append(to_string(part.kind))
                                  .append(" ")
                                  .append(part.name));
}

void AccessScope::require_everything(std::string_view operation) const {
    if (!access_->everything()) throw_undeclared(system_, std::string{"calls "}.append(operation));
}

}  // namespace rambla::ecs::detail
