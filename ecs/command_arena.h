#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace rambla::ecs {

/// Bytes handed out one after another from blocks that are kept for the next time: nothing moves, nothing is
/// freed one by one, and a steady use does not allocate.
class CommandArena {
public:
    static constexpr std::size_t k_block_bytes = 64 * 1024;

    /// Raw memory, aligned to `alignment`, a power of two of at most 64; valid until clear().
    [[nodiscard]] void* take(std::size_t bytes, std::size_t alignment);
    /// Forgets the contents, keeps the blocks.
    void clear() noexcept {
        block_ = 0;
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

    std::vector<Block> blocks_;
    std::size_t block_ = 0;  ///< the one being filled
    std::size_t used_ = 0;   ///< bytes of it
};

}  // namespace rambla::ecs
