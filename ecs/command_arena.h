#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
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
        const std::size_t skipped = -reinterpret_cast<std::uintptr_t>(free_) & (alignment - 1);
        if (skipped + bytes > static_cast<std::size_t>(end_ - free_)) return take_from_next(bytes);
        free_ += skipped + bytes;
        return free_ - bytes;
    }
    /// Raw memory right behind what was taken last. Null if its block is full.
    [[nodiscard]] std::byte* take_behind(std::size_t bytes) {
        if (bytes > static_cast<std::size_t>(end_ - free_)) return nullptr;
        return std::exchange(free_, free_ + bytes);
    }
    /// Forgets the contents, keeps the blocks.
    void clear() noexcept {
        next_ = 0;
        free_ = nullptr;
        end_ = nullptr;
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
    std::size_t next_ = 0;       ///< the block to fill next
    std::byte* free_ = nullptr;  ///< what is left of the one being filled
    std::byte* end_ = nullptr;
};

}  // namespace rambla::ecs
