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

void* CommandArena::take(std::size_t bytes, std::size_t alignment) {
    for (; block_ < blocks_.size(); ++block_, used_ = 0) {
        const std::size_t begin = (used_ + alignment - 1) / alignment * alignment;
        if (begin + bytes > blocks_[block_].size) continue;
        used_ = begin + bytes;
        return blocks_[block_].bytes.get() + begin;
    }
    const std::size_t size = std::max(bytes, k_block_bytes);
    std::unique_ptr<std::byte, Deleter> block{static_cast<std::byte*>(::operator new(size, k_alignment))};
    blocks_.push_back({std::move(block), size});
    used_ = bytes;
    return blocks_.back().bytes.get();
}

std::size_t CommandArena::memory_bytes() const {
    std::size_t bytes = blocks_.capacity() * sizeof(Block);
    for (const Block& block : blocks_)
        bytes += block.size;
    return bytes;
}

}  // namespace rambla::ecs
