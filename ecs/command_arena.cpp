#include "ecs/command_arena.h"

#include <algorithm>
#include <new>

namespace rambla::ecs {
namespace {

constexpr std::align_val_t k_alignment{64};

}  // namespace

void CommandArena::Deleter::operator()(std::byte* block) const noexcept {
    ::operator delete(block, k_alignment);
}

std::byte* CommandArena::take_from_next(std::size_t bytes) {
    while (next_ < blocks_.size() && blocks_[next_].size < bytes)
        ++next_;
    if (next_ == blocks_.size()) {
        const std::size_t doubled = blocks_.empty() ? k_first_block_bytes : blocks_.back().size * 2;
        const std::size_t size = std::max(bytes, std::min(doubled, k_block_bytes));
        blocks_.push_back(
            {std::unique_ptr<std::byte, Deleter>{static_cast<std::byte*>(::operator new(size, k_alignment))},
             size});
    }
    std::byte* const first = blocks_[next_].bytes.get();
    free_ = first + bytes;
    end_ = first + blocks_[next_].size;
    ++next_;
    return first;
}

std::size_t CommandArena::memory_bytes() const {
    std::size_t bytes = blocks_.capacity() * sizeof(Block);
    for (const Block& block : blocks_)
        bytes += block.size;
    return bytes;
}

}  // namespace rambla::ecs
