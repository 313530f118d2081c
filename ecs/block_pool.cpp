#include "ecs/block_pool.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <iterator>
#include <new>
#include <utility>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

constexpr std::size_t k_grain = 64;

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

}  // namespace

BlockPool::BlockPool(std::pmr::memory_resource* memory)
    : memory_{memory != nullptr ? memory : std::pmr::new_delete_resource()} {}

BlockPool::~BlockPool() {
    for (std::byte* slab : slabs_)
        memory_->deallocate(slab, k_slab_bytes, k_grain);
}

std::byte* BlockPool::allocate(std::size_t bytes) {
    try {
        return static_cast<std::byte*>(memory_->allocate(bytes, k_grain));
    } catch (const std::bad_alloc&) {
        detail::throw_no_memory("memory", bytes);
    }
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
        memory_->deallocate(block, bytes, k_grain);
        large_bytes_ -= bytes;
        return;
    }
    add_free(block, class_of(bytes));
}

std::byte* BlockPool::cut(std::size_t bytes) {
    if (k_slab_bytes - used_of_last_ < bytes) {
        if (slabs_.size() == slabs_.capacity()) slabs_.reserve(std::max<std::size_t>(8, slabs_.size() * 2));
        std::byte* slab = allocate(k_slab_bytes);
        cut_rest();
        slabs_.push_back(slab);
        used_of_last_ = 0;
    }
    std::byte* block = slabs_.back() + used_of_last_;
    used_of_last_ += bytes;
    return block;
}

void BlockPool::cut_rest() noexcept {
    while (used_of_last_ < k_slab_bytes) {
        const std::size_t left = std::min(k_slab_bytes - used_of_last_, k_largest_pooled);
        const std::size_t fitting = class_of(left);
        const std::size_t size_class = size_of_class(fitting) <= left ? fitting : fitting - 1;
        add_free(slabs_.back() + used_of_last_, size_class);
        used_of_last_ += size_of_class(size_class);
    }
}

void BlockPool::compact() {
    // Free bytes by slab, slabs by address. Which slabs go depends on what was taken and given back only.
    std::vector<std::pair<std::byte*, std::size_t>> free_bytes;
    for (std::byte* slab : slabs_)
        free_bytes.emplace_back(slab, 0);
    cut_rest();
    std::ranges::sort(free_bytes, std::less<>{}, [](const auto& slab) { return slab.first; });
    const auto slab_of = [&](const void* block) -> std::pair<std::byte*, std::size_t>& {
        return *std::prev(std::ranges::upper_bound(free_bytes, static_cast<const std::byte*>(block),
                                                   std::less<>{},
                                                   [](const auto& slab) { return slab.first; }));
    };
    for (std::size_t i = 0; i < free_.size(); ++i) {
        for (const FreeBlock* block = free_[i]; block != nullptr; block = block->next)
            slab_of(block).second += size_of_class(i);
    }
    for (FreeBlock*& first : free_) {
        FreeBlock** link = &first;
        while (*link != nullptr) {
            if (slab_of(*link).second == k_slab_bytes) {
                *link = (*link)->next;
            } else {
                link = &(*link)->next;
            }
        }
    }
    std::erase_if(slabs_, [&](std::byte* slab) {
        if (slab_of(slab).second != k_slab_bytes) return false;
        memory_->deallocate(slab, k_slab_bytes, k_grain);
        return true;
    });
}

void BlockPool::add_free(std::byte* block, std::size_t size_class) noexcept {
    free_[size_class] = new (block) FreeBlock{free_[size_class]};
}

}  // namespace rambla::ecs
