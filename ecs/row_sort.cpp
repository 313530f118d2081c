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
    for (unsigned shift = 0; shift < bits; shift += digit_bits) {
        std::array<std::uint32_t, k_most_digits> next{};
        for (const RowCommand& item : from)
            ++next[item.row >> shift & last_digit];
        std::uint32_t sum = 0;
        for (std::uint32_t& count : std::span{next}.first(last_digit + std::size_t{1}))
            sum += std::exchange(count, sum);
        for (const RowCommand& item : from)
            to[next[item.row >> shift & last_digit]++] = item;
        std::swap(from, to);
    }
    if (from.data() != items.data()) std::ranges::copy(from, items.begin());
}

}  // namespace rambla::ecs::detail
