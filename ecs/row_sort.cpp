#include "ecs/row_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace rambla::ecs::detail {
namespace {

/// More counters than 2¹¹ do not stay in the innermost cache.
constexpr unsigned k_most_digit_bits = 11;
constexpr std::uint32_t k_most_digits = 1u << k_most_digit_bits;
constexpr unsigned k_most_passes = (32 + k_most_digit_bits - 1) / k_most_digit_bits;

/// Below this, counting digits costs more than inserting.
constexpr std::size_t k_few = 48;

void insert_in_order(std::span<RowCommand> items) {
    for (std::size_t i = 1; i < items.size(); ++i) {
        const RowCommand item = items[i];
        std::size_t place = i;
        for (; place > 0 && items[place - 1].row > item.row; --place)
            items[place] = items[place - 1];
        items[place] = item;
    }
}

}  // namespace

void sort_by_row(std::span<RowCommand> items, std::span<RowCommand> scratch, std::uint32_t highest_row) {
    if (items.size() <= k_few) return insert_in_order(items);
    std::span<RowCommand> from = items;
    std::span<RowCommand> to = scratch.first(items.size());
    const auto bits = static_cast<unsigned>(std::bit_width(highest_row));
    const unsigned passes = (bits + k_most_digit_bits - 1) / k_most_digit_bits;
    const unsigned digit_bits = passes == 0 ? 0 : (bits + passes - 1) / passes;
    const std::uint32_t last_digit = (1u << digit_bits) - 1;
    std::array<std::array<std::uint32_t, k_most_digits>, k_most_passes> places;
    for (auto& next : std::span{places}.first(passes))
        std::ranges::fill_n(next.begin(), last_digit + std::ptrdiff_t{1}, 0u);
    for (const RowCommand& item : items) {
        for (unsigned pass = 0; pass < passes; ++pass)
            ++places[pass][item.row >> pass * digit_bits & last_digit];
    }
    for (unsigned pass = 0; pass < passes; ++pass) {
        std::span<std::uint32_t> next = std::span{places[pass]}.first(last_digit + std::size_t{1});
        std::uint32_t sum = 0;
        for (std::uint32_t& count : next)
            sum += std::exchange(count, sum);
        for (const RowCommand& item : from)
            to[next[item.row >> pass * digit_bits & last_digit]++] = item;
        std::swap(from, to);
    }
    if (from.data() != items.data()) std::ranges::copy(from, items.begin());
}

}  // namespace rambla::ecs::detail
