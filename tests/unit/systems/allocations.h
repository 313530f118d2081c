#pragma once

#include <cstddef>

namespace rambla::test {

/// Number of times that any thread of this program has called operator new.
[[nodiscard]] std::size_t allocations();

}  // namespace rambla::test
