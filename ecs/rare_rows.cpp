#include "ecs/rare_rows.h"

#include <utility>

namespace rambla::ecs::detail {

constinit thread_local std::unique_ptr<RareRows::List> RareRows::spare_;

void RareRows::GiveBack::operator()(List* list) const noexcept {
    list->next = std::move(spare_);
    spare_.reset(list);
}

RareRows::Lent RareRows::borrow() {
    if (spare_ == nullptr) return Lent{new List};
    List* const list = spare_.release();
    spare_ = std::move(list->next);
    return Lent{list};
}

}  // namespace rambla::ecs::detail
