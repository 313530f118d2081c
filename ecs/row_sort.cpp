#include "ecs/row_sort.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rambla::ecs::detail {
namespace {

constexpr unsigned k_digit_bits = 11;
constexpr std::uint32_t k_digits = 1u << k_digit_bits;

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
    for (unsigned shift = 0; shift < 32 && highest_row >> shift != 0; shift += k_digit_bits) {
        std::array<std::uint32_t, k_digits> next{};
        for (const RowCommand& item : from)
            ++next[item.row >> shift & (k_digits - 1)];
        std::uint32_t sum = 0;
        for (std::uint32_t& count : next)
            sum += std::exchange(count, sum);
        for (const RowCommand& item : from)
            to[next[item.row >> shift & (k_digits - 1)]++] = item;
        std::swap(from, to);
    }
    if (from.data() != items.data()) std::ranges::copy(from, items.begin());
}

}  // namespace rambla::ecs::detail
