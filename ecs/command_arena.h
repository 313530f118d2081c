#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace rambla::ecs {

/// Bytes handed out one after another from blocks that are kept for the next time: nothing moves, nothing is
/// freed one by one, and a steady use does not allocate. Blocks double in size, so that many small users stay
/// small.
class CommandArena {
public:
    static constexpr std::size_t k_first_block_bytes = 2 * 1024;
    static constexpr std::size_t k_block_bytes = 64 * 1024;

    /// Raw memory, aligned to `alignment`, a power of two of at most 64; valid until clear().
    [[nodiscard]] std::byte* take(std::size_t bytes, std::size_t alignment) {
        const std::size_t begin = (used_ + alignment - 1) & ~(alignment - 1);
        if (begin + bytes > size_) return take_from_next(bytes);
        used_ = begin + bytes;
        return bytes_ + begin;
    }
    /// Forgets the contents, keeps the blocks.
    void clear() noexcept {
        next_ = 0;
        bytes_ = nullptr;
        size_ = 0;
        used_ = 0;
    }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct Deleter {
        void operator()(std::byte* block) const noexcept;
    };
    struct Block {
        std::unique_ptr<std::byte, Deleter> bytes;
        std::size_t size;
    };

    std::byte* take_from_next(std::size_t bytes);

    std::vector<Block> blocks_;
    std::size_t next_ = 0;        ///< the block to fill next
    std::byte* bytes_ = nullptr;  ///< the one being filled
    std::size_t size_ = 0;        ///< bytes of it
    std::size_t used_ = 0;        ///< bytes of it that are taken
};

}  // namespace rambla::ecs
