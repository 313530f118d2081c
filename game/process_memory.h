#pragma once

#include <cstdint>

namespace rambla::game {

/// Resident memory of this process in bytes, from /proc/self/statm; 0 where that does not exist.
[[nodiscard]] std::uint64_t resident_bytes();

}  // namespace rambla::game
