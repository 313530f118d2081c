#pragma once

#include <cstdint>

namespace rambla::game {

/// Bytes in use by C++ allocations of the whole process, libraries included. Linking this file replaces
/// operator new and delete. C libraries allocate past it, the GL driver among them. 0 where a sanitizer owns
/// the heap.
[[nodiscard]] std::uint64_t heap_bytes();

}  // namespace rambla::game
