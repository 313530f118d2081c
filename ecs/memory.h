#pragma once

#include <cstddef>

namespace rambla::ecs {

/// Bytes that grow in place: a range of address space, of which a growing first part is backed by memory.
/// Where the system has no such thing, growth allocates anew and copies the bytes (grows_in_place is false
/// there).
class ReservedMemory {
public:
    /// Whether this system has ranges of address space.
    static const bool grows_in_place;
    static constexpr std::size_t k_pages_per_table = 512;

    ReservedMemory() = default;
    /// Reserves, commits nothing. Throws CapacityExceeded when the address space is used up.
    explicit ReservedMemory(std::size_t max_bytes);
    /// The same, beginning at a page of one's choice among the k_pages_per_table that one table of the
    /// system's translates; where there are no ranges, anywhere.
    /// @param page  < k_pages_per_table
    ReservedMemory(std::size_t max_bytes, std::size_t page);
    ReservedMemory(ReservedMemory&& other) noexcept;
    ReservedMemory& operator=(ReservedMemory&& other) noexcept;
    ~ReservedMemory();

    /// Makes at least the first `bytes` usable; new bytes are zero. At most max_bytes. Throws
    /// CapacityExceeded when the system refuses; what was committed before stays as it is.
    void commit(std::size_t bytes);

    /// Keeps at least the first `bytes` usable and gives the rest back, where grows_in_place. Cannot fail:
    /// what the system does not take back stays.
    void decommit(std::size_t bytes) noexcept;

    /// Start of the bytes, aligned to 64; where grows_in_place it stays the same for life.
    [[nodiscard]] std::byte* data() const { return data_; }
    /// Usable now.
    [[nodiscard]] std::size_t committed_bytes() const { return committed_bytes_; }
    /// What committed_bytes() may grow to.
    [[nodiscard]] std::size_t reserved_bytes() const { return reserved_bytes_; }

private:
    void reserve(std::size_t spare_bytes);
    void release() noexcept;

    std::byte* data_ = nullptr;
    std::size_t spare_bytes_ = 0;    ///< reserved in excess, for the choice of a page
    std::size_t skipped_bytes_ = 0;  ///< of these, before data_
    std::size_t committed_bytes_ = 0;
    std::size_t reserved_bytes_ = 0;
};

}  // namespace rambla::ecs
