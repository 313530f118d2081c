#include "ecs/component.h"

#include <atomic>

namespace rambla::ecs::detail {

std::uint32_t next_type_index() {
    static std::atomic<std::uint32_t> next{0};
    return next.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace rambla::ecs::detail
