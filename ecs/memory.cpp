#include "ecs/memory.h"

#include <utility>

#include "ecs/misuse.h"

#if (defined(__unix__) || defined(__APPLE__)) && !defined(RAMBLA_ECS_NO_MMAP)
#include <sys/mman.h>
#include <unistd.h>
#define RAMBLA_ECS_MMAP 1
#else
#include <cstring>
#include <new>
#define RAMBLA_ECS_MMAP 0
#endif

namespace rambla::ecs {

ReservedMemory::ReservedMemory(ReservedMemory&& other) noexcept
    : data_{std::exchange(other.data_, nullptr)},
      committed_bytes_{std::exchange(other.committed_bytes_, 0)},
      reserved_bytes_{std::exchange(other.reserved_bytes_, 0)} {}

ReservedMemory& ReservedMemory::operator=(ReservedMemory&& other) noexcept {
    if (this == &other) return *this;
    release();
    data_ = std::exchange(other.data_, nullptr);
    committed_bytes_ = std::exchange(other.committed_bytes_, 0);
    reserved_bytes_ = std::exchange(other.reserved_bytes_, 0);
    return *this;
}

ReservedMemory::~ReservedMemory() {
    release();
}

#if RAMBLA_ECS_MMAP

namespace {

std::size_t whole_pages(std::size_t bytes) {
    static const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return (bytes + page - 1) / page * page;
}

}  // namespace

const bool ReservedMemory::grows_in_place = true;

ReservedMemory::ReservedMemory(std::size_t max_bytes) : reserved_bytes_{whole_pages(max_bytes)} {
    if (reserved_bytes_ == 0) return;
    void* address = mmap(nullptr, reserved_bytes_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (address == MAP_FAILED) detail::throw_no_memory("address space", reserved_bytes_);
    data_ = static_cast<std::byte*>(address);
}

void ReservedMemory::commit(std::size_t bytes) {
    const std::size_t wanted = whole_pages(bytes);
    if (wanted <= committed_bytes_) return;
    if (wanted > reserved_bytes_) detail::throw_full("bytes of reserved memory", reserved_bytes_);
    if (mprotect(data_ + committed_bytes_, wanted - committed_bytes_, PROT_READ | PROT_WRITE) != 0) {
        detail::throw_no_memory("memory", wanted - committed_bytes_);
    }
    committed_bytes_ = wanted;
}

void ReservedMemory::release() noexcept {
    if (data_ != nullptr) munmap(data_, reserved_bytes_);
}

#else

namespace {

constexpr std::align_val_t k_alignment{64};

}  // namespace

const bool ReservedMemory::grows_in_place = false;

ReservedMemory::ReservedMemory(std::size_t max_bytes) : reserved_bytes_{max_bytes} {}

void ReservedMemory::commit(std::size_t bytes) {
    if (bytes <= committed_bytes_) return;
    if (bytes > reserved_bytes_) detail::throw_full("bytes of reserved memory", reserved_bytes_);
    void* fresh = ::operator new(bytes, k_alignment, std::nothrow);
    if (fresh == nullptr) detail::throw_no_memory("memory", bytes);
    if (committed_bytes_ != 0) std::memcpy(fresh, data_, committed_bytes_);
    std::memset(static_cast<std::byte*>(fresh) + committed_bytes_, 0, bytes - committed_bytes_);
    release();
    data_ = static_cast<std::byte*>(fresh);
    committed_bytes_ = bytes;
}

void ReservedMemory::release() noexcept {
    ::operator delete(data_, k_alignment);
}

#endif

}  // namespace rambla::ecs
