#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "ecs/component.h"

namespace rambla::ecs::detail {

template <class Word>
[[gnu::always_inline]] inline void copy_two(std::byte* to, const std::byte* from,
                                            std::size_t second) noexcept {
    Word words[2];
    std::memcpy(&words[0], from, sizeof(Word));
    std::memcpy(&words[1], from + second, sizeof(Word));
    std::memcpy(to, &words[0], sizeof(Word));
    std::memcpy(to + second, &words[1], sizeof(Word));
}

/// What copy_few() takes.
inline constexpr std::size_t k_few_bytes = 32;

/// Copies at most k_few_bytes that do not overlap. A call of memcpy costs more than most rows hold: they are
/// copied by their first and their last words, which overlap where the size is between two powers of two.
[[gnu::always_inline]] inline void copy_few(std::byte* to, const std::byte* from, std::size_t size) noexcept {
    struct Sixteen {
        std::uint64_t low, high;
    };
    if (size - 8 <= 8) {  // asked first: most components are that small
        copy_two<std::uint64_t>(to, from, size - 8);
    } else if (size > 16) {
        copy_two<Sixteen>(to, from, size - 16);
    } else if (size >= 4) {
        copy_two<std::uint32_t>(to, from, size - 4);
    } else {
        for (std::size_t i = 0; i < size; ++i)
            to[i] = from[i];
    }
}

/// Copies `size` bytes that do not overlap.
[[gnu::always_inline]] inline void copy_row(std::byte* to, const std::byte* from, std::size_t size) noexcept {
    if (size > k_few_bytes) {
        std::memcpy(to, from, size);
    } else {
        copy_few(to, from, size);
    }
}

/// Moves `rows` neighbouring rows to raw memory that does not overlap; the sources are raw from then on.
inline void relocate_rows(const ComponentInfo& info, std::byte* to, std::byte* from,
                          std::size_t rows) noexcept {
    if (info.relocate != nullptr) {
        info.relocate(to, from, rows);
    } else {
        std::memcpy(to, from, rows * info.size);
    }
}

inline void destroy_rows(const ComponentInfo& info, std::byte* first, std::size_t rows) noexcept {
    if (info.destroy != nullptr) info.destroy(first, rows);
}

}  // namespace rambla::ecs::detail
