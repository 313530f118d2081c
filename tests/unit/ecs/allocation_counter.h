#pragma once

#include <cstddef>

namespace rambla::ecs::test {

/// Allocations through operator new since the program began, all threads, all forms.
[[nodiscard]] std::size_t allocation_count();

}  // namespace rambla::ecs::test
