#pragma once

#include <cstdint>
#include <span>

namespace rambla::ecs::detail {

/// A command and the row that it is about.
struct RowCommand {
    std::uint32_t row;
    std::uint32_t command;
};

/// Sorts by rows; commands of one row keep their order. Radix sort from the lowest bits on, as many at
/// a time as make the fewest passes of at most 11 bits each.
/// @param scratch      as long as `items`
/// @param highest_row  that occurs
void sort_by_row(std::span<RowCommand> items, std::span<RowCommand> scratch, std::uint32_t highest_row);

}  // namespace rambla::ecs::detail
