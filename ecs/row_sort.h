#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace rambla::ecs::detail {

/// A command and the row that it is about.
struct RowCommand {
    std::uint32_t row;
    std::uint32_t command;
};

/// The rows of such a list.
class RowsOf {
public:
    explicit RowsOf(std::span<const RowCommand> items) : items_{items} {}

    [[nodiscard]] std::size_t size() const { return items_.size(); }
    [[nodiscard]] std::uint32_t operator[](std::size_t i) const { return items_[i].row; }
    [[nodiscard]] RowsOf first(std::size_t count) const { return RowsOf{items_.first(count)}; }

private:
    std::span<const RowCommand> items_;
};

/// Sorts by rows; commands of one row keep their order. Radix sort from the lowest bits on, as many at
/// a time as make the fewest passes of at most 11 bits each.
/// @param scratch      as long as `items`
/// @param highest_row  that occurs
void sort_by_row(std::span<RowCommand> items, std::span<RowCommand> scratch, std::uint32_t highest_row);

}  // namespace rambla::ecs::detail
