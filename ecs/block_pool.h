#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>
#include <vector>

namespace rambla::ecs {

/// Hands out small blocks of memory, aligned to 64 bytes, cut from shared slabs, and takes them back:
/// thousands of small archetypes share a few slabs. Sizes are rounded up to four steps per power of two, so
/// at most a fifth of a block is lost. Blocks above k_largest_pooled come from the heap, one by one.
class BlockPool {
public:
    /// Bytes of the largest block that is cut from a slab.
    static constexpr std::size_t k_largest_pooled = 16 * 1024;
    /// Bytes that are asked for at a time.
    static constexpr std::size_t k_slab_bytes = 64 * 1024;

    /// @param memory  where slabs and large blocks come from, null: the heap; outlives the pool
    explicit BlockPool(std::pmr::memory_resource* memory = nullptr);
    ~BlockPool();
    BlockPool(const BlockPool&) = delete;
    BlockPool& operator=(const BlockPool&) = delete;

    /// @param bytes  > 0
    [[nodiscard]] std::byte* take(std::size_t bytes);
    /// @param bytes  what take() was asked for
    void give_back(std::byte* block, std::size_t bytes) noexcept;

    /// Gives back slabs all of whose blocks are free.
    void compact();

    /// Slabs and large blocks that are held from the system.
    [[nodiscard]] std::size_t memory_bytes() const { return slabs_.size() * k_slab_bytes + large_bytes_; }

private:
    struct FreeBlock {
        FreeBlock* next;
    };
    static constexpr std::size_t k_class_count = 28;

    [[nodiscard]] std::byte* allocate(std::size_t bytes);
    [[nodiscard]] std::byte* cut(std::size_t bytes);
    /// Makes free blocks of what is left of the last slab.
    void cut_rest() noexcept;
    void add_free(std::byte* block, std::size_t size_class) noexcept;

    std::array<FreeBlock*, k_class_count> free_{};
    std::pmr::memory_resource* memory_;
    std::vector<std::byte*> slabs_;
    std::size_t used_of_last_ = k_slab_bytes;  ///< bytes of the last slab that are cut off already
    std::size_t large_bytes_ = 0;
};

}  // namespace rambla::ecs
