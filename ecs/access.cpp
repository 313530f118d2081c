#include "ecs/access.h"

#include <algorithm>

namespace rambla::ecs {

std::string_view to_string(AccessKind kind) {
    return kind == AccessKind::component ? "component" : "resource";
}

void AccessSet::add(const AccessPart& part) {
    const auto old =
        std::find_if(parts_.begin(), parts_.end(), [&](const AccessPart& p) { return p.same_thing(part); });
    if (old == parts_.end()) {
        parts_.push_back(part);
    } else {
        old->writes |= part.writes;
    }
}

bool AccessSet::covers(AccessKind kind, std::uint32_t type_index, bool writing) const {
    if (everything_) return true;
    return std::any_of(parts_.begin(), parts_.end(), [&](const AccessPart& part) {
        return part.kind == kind && part.type_index == type_index && (part.writes || !writing);
    });
}

Conflict conflict_between(const AccessSet& first, const AccessSet& second) {
    Conflict conflict;
    conflict.exclusive = first.everything() || second.everything();
    for (const AccessPart& mine : first.parts()) {
        for (const AccessPart& other : second.parts()) {
            if (mine.same_thing(other) && (mine.writes || other.writes)) conflict.parts.push_back(mine);
        }
    }
    return conflict;
}

}  // namespace rambla::ecs
