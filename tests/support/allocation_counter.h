#pragma once

#include <cstddef>

namespace rambla::test {

/// Calls of operator new since the program began, all forms. Linking this file replaces operator new and
/// delete.
[[nodiscard]] std::size_t allocation_count();
/// The same, of the calling thread alone.
[[nodiscard]] std::size_t allocation_count_of_this_thread();

}  // namespace rambla::test
