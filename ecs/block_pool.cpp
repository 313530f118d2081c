#include "ecs/block_pool.h"

#include <bit>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

constexpr std::size_t k_grain = 64;
constexpr std::align_val_t k_alignment{k_grain};

/// Classes 0…3 hold 64, 128, 192, 256 bytes; from there each doubling has four equal steps.
constexpr std::size_t size_of_class(std::size_t size_class) {
    if (size_class < 4) return (size_class + 1) * k_grain;
    const std::size_t octave = (256u << (size_class / 4 - 1));
    return octave + (size_class % 4 + 1) * (octave / 4);
}

/// The smallest class that holds `bytes`.
constexpr std::size_t class_of(std::size_t bytes) {
    if (bytes <= 256) return (bytes + k_grain - 1) / k_grain - 1;
    const std::size_t octave_bits =
        static_cast<std::size_t>(std::bit_width(bytes - 1)) - 1;  // octave < bytes
    const std::size_t octave = std::size_t{1} << octave_bits;
    const std::size_t step = octave / 4;
    return (octave_bits - 7) * 4 + (bytes - octave + step - 1) / step - 1;
}

static_assert(size_of_class(class_of(1)) == 64 && size_of_class(class_of(256)) == 256);
static_assert(size_of_class(class_of(257)) == 320 && size_of_class(class_of(512)) == 512);
static_assert(size_of_class(class_of(513)) == 640);
static_assert(size_of_class(27) == BlockPool::k_largest_pooled &&
              class_of(BlockPool::k_largest_pooled) == 27);

std::byte* allocate(std::size_t bytes) {
    void* memory = ::operator new(bytes, k_alignment, std::nothrow);
    if (memory == nullptr) detail::throw_no_memory("memory", bytes);
    return static_cast<std::byte*>(memory);
}

}  // namespace

void BlockPool::AlignedDelete::operator()(std::byte* slab) const noexcept {
    ::operator delete(slab, k_alignment);
}

std::byte* BlockPool::take(std::size_t bytes) {
    if (bytes > k_largest_pooled) {
        std::byte* block = allocate(bytes);
        large_bytes_ += bytes;
        return block;
    }
    FreeBlock*& free = free_[class_of(bytes)];
    if (free == nullptr) return cut(size_of_class(class_of(bytes)));
    FreeBlock* block = free;
    free = block->next;
    return reinterpret_cast<std::byte*>(block);
}

void BlockPool::give_back(std::byte* block, std::size_t bytes) noexcept {
    if (bytes > k_largest_pooled) {
        ::operator delete(block, k_alignment);
        large_bytes_ -= bytes;
        return;
    }
    add_free(block, class_of(bytes));
}

std::byte* BlockPool::cut(std::size_t bytes) {
    if (k_slab_bytes - used_of_last_ < bytes) {
        std::unique_ptr<std::byte, AlignedDelete> slab{allocate(k_slab_bytes)};
        slabs_.reserve(slabs_.size() + 1);
        while (used_of_last_ < k_slab_bytes) {  // what is left of the old slab serves smaller requests
            const std::size_t left = k_slab_bytes - used_of_last_;
            const std::size_t fitting = class_of(left);
            const std::size_t size_class = size_of_class(fitting) <= left ? fitting : fitting - 1;
            add_free(slabs_.back().get() + used_of_last_, size_class);
            used_of_last_ += size_of_class(size_class);
        }
        slabs_.push_back(std::move(slab));
        used_of_last_ = 0;
    }
    std::byte* block = slabs_.back().get() + used_of_last_;
    used_of_last_ += bytes;
    return block;
}

void BlockPool::add_free(std::byte* block, std::size_t size_class) noexcept {
    free_[size_class] = new (block) FreeBlock{free_[size_class]};
}

}  // namespace rambla::ecs
