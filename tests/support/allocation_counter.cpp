#include "support/allocation_counter.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocations{0};
thread_local std::size_t allocations_of_this_thread = 0;
thread_local std::size_t failing_one = ~std::size_t{0};  ///< by its number among those of this thread

void* allocate_or_null(std::size_t bytes, std::size_t alignment) {
    ++allocations;
    if (allocations_of_this_thread++ == failing_one) return nullptr;
    return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* allocate(std::size_t bytes, std::size_t alignment) {
    void* memory = allocate_or_null(bytes, alignment);
    if (memory == nullptr) throw std::bad_alloc{};
    return memory;
}

}  // namespace

std::size_t rambla::test::allocation_count() {
    return allocations;
}

std::size_t rambla::test::allocation_count_of_this_thread() {
    return allocations_of_this_thread;
}

rambla::test::FailingAllocation::FailingAllocation(std::size_t number) {
    failing_one = allocations_of_this_thread + number;
}

rambla::test::FailingAllocation::~FailingAllocation() {
    failing_one = ~std::size_t{0};
}

bool rambla::test::FailingAllocation::happened() const {
    return allocations_of_this_thread > failing_one;
}

// The array forms call these.
void* operator new(std::size_t bytes) {
    return allocate(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return allocate_or_null(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocate_or_null(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
