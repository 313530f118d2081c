#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace rambla::ecs {

/// A set of rows of one chunk: one bit per row, 1024 in all.
class RowMask {
public:
    /// Words of 64 rows.
    static constexpr std::size_t k_words = 16;
    /// Rows of a chunk.
    static constexpr std::size_t k_rows = k_words * 64;

    /// The rows before `count`, at most 1024.
    [[nodiscard]] static constexpr RowMask first(std::size_t count) {
        RowMask mask;
        for (std::size_t i = 0; i < k_words && i * 64 < count; ++i) {
            const std::size_t left = count - i * 64;
            mask.words_[i] = left >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << left) - 1;
        }
        return mask;
    }

    /// The rows before `count` whose byte, 0 or 1, is zero. Reads up to the next multiple of 8; what stands
    /// there does not matter.
    [[nodiscard]] static RowMask of_zeros(const std::uint8_t* bytes, std::size_t count) {
        static_assert(std::endian::native == std::endian::little);
        RowMask ones;
        for (std::size_t row = 0; row < count; row += 8) {
            std::uint64_t eight = 0;
            std::memcpy(&eight, bytes + row, 8);
            eight &= 0x0101010101010101u;  // raw memory behind the last row would carry into the rows before
            // Byte i is worth 2^(8i): times 2^(56−7i) it lands on bit 56 + i, and nothing else lands above.
            ones.words_[row / 64] |= (eight * 0x0102040810204080u >> 56u) << (row % 64);
        }
        RowMask zeros = first(count);
        for (std::size_t i = 0; i < k_words; ++i)
            zeros.words_[i] &= ~ones.words_[i];
        return zeros;
    }

    /// Whether a row, below 1024, is in the set.
    [[nodiscard]] constexpr bool test(std::size_t row) const {
        return (words_[row / 64] >> (row % 64) & 1u) != 0;
    }
    /// Puts a row in.
    constexpr void set(std::size_t row) { words_[row / 64] |= std::uint64_t{1} << (row % 64); }
    /// Takes a row out.
    constexpr void reset(std::size_t row) { words_[row / 64] &= ~(std::uint64_t{1} << (row % 64)); }

    /// Whether a row is in the set.
    [[nodiscard]] constexpr bool any() const {
        return std::ranges::any_of(words_, [](std::uint64_t word) { return word != 0; });
    }
    /// Number of rows in the set.
    [[nodiscard]] constexpr std::size_t count() const {
        std::size_t rows = 0;
        for (std::uint64_t word : words_)
            rows += static_cast<std::size_t>(std::popcount(word));
        return rows;
    }
    /// Row r is bit r % 64 of word r / 64.
    [[nodiscard]] constexpr const std::array<std::uint64_t, k_words>& words() const { return words_; }

    /// Keeps the rows that are in both.
    constexpr RowMask& operator&=(const RowMask& other) {
        for (std::size_t i = 0; i < k_words; ++i)
            words_[i] &= other.words_[i];
        return *this;
    }
    /// Adds the other's rows.
    constexpr RowMask& operator|=(const RowMask& other) {
        for (std::size_t i = 0; i < k_words; ++i)
            words_[i] |= other.words_[i];
        return *this;
    }
    /// Takes out the other's rows.
    constexpr RowMask& operator-=(const RowMask& other) {
        for (std::size_t i = 0; i < k_words; ++i)
            words_[i] &= ~other.words_[i];
        return *this;
    }
    bool operator==(const RowMask&) const = default;

    /// Takes out the rows for which wanted(row) is false; asks only about those that are in.
    template <class F>
    constexpr void keep_if(F&& wanted) {
        for (std::size_t i = 0; i < k_words; ++i) {
            for (std::uint64_t word = words_[i]; word != 0; word &= word - 1) {
                const auto bit = static_cast<std::size_t>(std::countr_zero(word));
                words_[i] &= ~(std::uint64_t{!wanted(i * 64 + bit)} << bit);
            }
        }
    }

    /// Goes through the rows in the set, ascending:
    ///     for (std::size_t row : chunk.rows()) …
    class Iterator {
    public:
        using value_type = std::size_t;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::input_iterator_tag;

        constexpr explicit Iterator(const RowMask& mask) : mask_{&mask}, left_{mask.words_[0]} { settle(); }
        constexpr std::size_t operator*() const {
            return word_ * 64 + static_cast<std::size_t>(std::countr_zero(left_));
        }
        constexpr Iterator& operator++() {
            left_ &= left_ - 1;
            settle();
            return *this;
        }
        constexpr void operator++(int) { ++*this; }
        constexpr bool operator==(std::default_sentinel_t) const { return left_ == 0; }

    private:
        constexpr void settle() {
            while (left_ == 0 && ++word_ < k_words)
                left_ = mask_->words_[word_];
        }

        const RowMask* mask_;
        std::size_t word_ = 0;
        std::uint64_t left_;
    };
    /// The first row in the set.
    [[nodiscard]] constexpr Iterator begin() const { return Iterator{*this}; }
    /// Behind the last one.
    [[nodiscard]] constexpr std::default_sentinel_t end() const { return {}; }

    /// Calls f(row) for every row in the set, ascending. Faster than begin() where most rows are in.
    template <class F>
    constexpr void for_each(F&& f) const {
        for (std::size_t i = 0; i < k_words; ++i) {
            std::uint64_t word = words_[i];
            if (word == ~std::uint64_t{0}) {  // without bit fiddling, so that the compiler may vectorise
                for (std::size_t row = i * 64; row < i * 64 + 64; ++row)
                    f(row);
                continue;
            }
            for (; word != 0; word &= word - 1)
                f(i * 64 + static_cast<std::size_t>(std::countr_zero(word)));
        }
    }

private:
    std::array<std::uint64_t, k_words> words_{};
};

}  // namespace rambla::ecs
