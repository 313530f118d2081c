#include "ecs/memory.h"

#include <cstdint>
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
      spare_bytes_{std::exchange(other.spare_bytes_, 0)},
      skipped_bytes_{std::exchange(other.skipped_bytes_, 0)},
      committed_bytes_{std::exchange(other.committed_bytes_, 0)},
      reserved_bytes_{std::exchange(other.reserved_bytes_, 0)} {}

ReservedMemory& ReservedMemory::operator=(ReservedMemory&& other) noexcept {
    if (this == &other) return *this;
    release();
    data_ = std::exchange(other.data_, nullptr);
    spare_bytes_ = std::exchange(other.spare_bytes_, 0);
    skipped_bytes_ = std::exchange(other.skipped_bytes_, 0);
    committed_bytes_ = std::exchange(other.committed_bytes_, 0);
    reserved_bytes_ = std::exchange(other.reserved_bytes_, 0);
    return *this;
}

ReservedMemory::~ReservedMemory() {
    release();
}

#if RAMBLA_ECS_MMAP

namespace {

std::size_t page_bytes() {
    static const std::size_t bytes = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return bytes;
}

std::size_t whole_pages(std::size_t bytes) {
    return (bytes + page_bytes() - 1) / page_bytes() * page_bytes();
}

// Walks and random access over millions of rows wait for the translation of addresses as much as for data.
// Large pages remove that: measured over a million rows, a random get takes 0.6 of the time, a walk over
// seven columns 0.9. The system takes them by itself only for a range whose every byte is committed when it
// is first touched; memory that grows in small steps must ask for each range as soon as it is complete.
// Refusals cost nothing but speed.
#if defined(__linux__) && defined(MADV_HUGEPAGE)

constexpr std::uintptr_t k_large_page = std::uintptr_t{2} << 20u;

void advise_large_pages(std::byte* first, std::size_t bytes) {
    (void)madvise(first, bytes, MADV_HUGEPAGE);
}

/// @param first, last  what is committed now, of which [first, old_last) was before
void complete_large_page(std::byte* first, std::byte* old_last, std::byte* last) {
    constexpr int k_collapse = 25;  // MADV_COLLAPSE, since Linux 6.1; not in every C library's headers
    const auto begin = reinterpret_cast<std::uintptr_t>(old_last) / k_large_page * k_large_page;
    const bool was_begun = begin != reinterpret_cast<std::uintptr_t>(old_last);
    const bool all_ours = begin >= reinterpret_cast<std::uintptr_t>(first) &&
                          begin + k_large_page <= reinterpret_cast<std::uintptr_t>(last);
    if (was_begun && all_ours) (void)madvise(reinterpret_cast<void*>(begin), k_large_page, k_collapse);
}

#else

void advise_large_pages(std::byte*, std::size_t) {}
void complete_large_page(std::byte*, std::byte*, std::byte*) {}

#endif

}  // namespace

const bool ReservedMemory::grows_in_place = true;

ReservedMemory::ReservedMemory(std::size_t max_bytes) : reserved_bytes_{whole_pages(max_bytes)} {
    reserve(0);
}

ReservedMemory::ReservedMemory(std::size_t max_bytes, std::size_t page)
    : reserved_bytes_{whole_pages(max_bytes)} {
    reserve(k_pages_per_table * page_bytes());
    const std::size_t first_page = reinterpret_cast<std::uintptr_t>(data_) / page_bytes();
    skipped_bytes_ = (page - first_page) % k_pages_per_table * page_bytes();
    if (data_ != nullptr) data_ += skipped_bytes_;
}

void ReservedMemory::reserve(std::size_t spare_bytes) {
    if (reserved_bytes_ == 0) return;
    void* address =
        mmap(nullptr, spare_bytes + reserved_bytes_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (address == MAP_FAILED) detail::throw_no_memory("address space", spare_bytes + reserved_bytes_);
    data_ = static_cast<std::byte*>(address);
    spare_bytes_ = spare_bytes;
    // What is alike is one mapping for the system, which has not many: the spare part, too.
    advise_large_pages(data_, spare_bytes + reserved_bytes_);
}

void ReservedMemory::commit(std::size_t bytes) {
    const std::size_t wanted = whole_pages(bytes);
    if (wanted <= committed_bytes_) return;
    if (wanted > reserved_bytes_) detail::throw_full("bytes of reserved memory", reserved_bytes_);
    if (mprotect(data_ + committed_bytes_, wanted - committed_bytes_, PROT_READ | PROT_WRITE) != 0) {
        detail::throw_no_memory("memory", wanted - committed_bytes_);
    }
    complete_large_page(data_, data_ + committed_bytes_, data_ + wanted);
    committed_bytes_ = wanted;
}

void ReservedMemory::decommit(std::size_t bytes) noexcept {
    const std::size_t kept = whole_pages(bytes);
    if (kept >= committed_bytes_) return;
    // A fresh mapping: madvise alone would leave the pages counted as committed.
    void* const tail = data_ + kept;
    const std::size_t tail_bytes = committed_bytes_ - kept;
    if (mmap(tail, tail_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) == MAP_FAILED)
        return;
    advise_large_pages(data_ + kept, tail_bytes);
    committed_bytes_ = kept;
}

void ReservedMemory::release() noexcept {
    if (data_ != nullptr) munmap(data_ - skipped_bytes_, spare_bytes_ + reserved_bytes_);
}

#else

namespace {

constexpr std::align_val_t k_alignment{64};

}  // namespace

const bool ReservedMemory::grows_in_place = false;

ReservedMemory::ReservedMemory(std::size_t max_bytes) : reserved_bytes_{max_bytes} {}
ReservedMemory::ReservedMemory(std::size_t max_bytes, std::size_t) : ReservedMemory{max_bytes} {}

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

void ReservedMemory::decommit(std::size_t) noexcept {}

void ReservedMemory::release() noexcept {
    ::operator delete(data_, k_alignment);
}

#endif

}  // namespace rambla::ecs
