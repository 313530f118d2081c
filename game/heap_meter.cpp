#include "game/heap_meter.h"

#include <malloc.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

/// Threads that count in one cache line would wait for each other.
constexpr std::size_t k_shards = 16;

struct alignas(64) Shard {
    std::atomic<std::int64_t> bytes{0};
};

constinit std::array<Shard, k_shards> shards{};
constinit std::atomic<std::size_t> next_shard{0};

}  // namespace

std::uint64_t rambla::game::heap_bytes() {
    std::int64_t sum = 0;
    for (const Shard& shard : shards)
        sum += shard.bytes.load(std::memory_order_relaxed);
    return sum > 0 ? static_cast<std::uint64_t>(sum) : 0;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

Shard& shard_of_this_thread() {
    thread_local const std::size_t index = next_shard.fetch_add(1, std::memory_order_relaxed) % k_shards;
    return shards[index];
}

void* allocate_or_null(std::size_t bytes, std::size_t alignment) {
    void* memory = alignment <= alignof(std::max_align_t)
                       ? std::malloc(bytes)
                       : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (memory != nullptr) {
        shard_of_this_thread().bytes.fetch_add(static_cast<std::int64_t>(malloc_usable_size(memory)),
                                               std::memory_order_relaxed);
    }
    return memory;
}

void* allocate(std::size_t bytes, std::size_t alignment) {
    while (true) {
        if (void* memory = allocate_or_null(bytes, alignment)) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc{};
        handler();
    }
}

void release(void* memory) {
    if (memory == nullptr) return;
    shard_of_this_thread().bytes.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(memory)),
                                           std::memory_order_relaxed);
    std::free(memory);
}

}  // namespace

// The array and nothrow forms call these.
void* operator new(std::size_t bytes) {
    return allocate(bytes > 0 ? bytes : 1, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes > 0 ? bytes : 1, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    release(memory);
}

#endif
