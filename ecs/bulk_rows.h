#pragma once

#include <cstdint>
#include <span>

#include "ecs/archetype.h"
#include "ecs/entity_table.h"
#include "ecs/row_sort.h"
#include "ecs/sparse_set.h"

namespace rambla::ecs::detail {

/// Changes of many rows of an archetype at once, column by column, so that the memory of one column is walked
/// through in one direction at a time. Lists of rows are ascending and without doubles.
struct BulkRows {
    EntityTable& entities;
    SparseSets& sparse;
    std::uint32_t version;  ///< that changed chunks are stamped with

    /// Makes sure that append() has room for `count` rows. Throws CapacityExceeded.
    static void reserve(Archetype& archetype, std::uint64_t count);

    /// Appends rows for new entities, whose slots EntityTable::reserve() has made sure of; their components
    /// are raw memory that the caller fills. Returns the first.
    std::uint32_t create(Archetype& to, std::uint32_t count) const noexcept;
    /// Appends rows for these entities, whose components are raw memory that the caller fills. Returns the
    /// first.
    std::uint32_t append(Archetype& to, std::span<const Entity> fresh) const noexcept;
    /// Moves rows behind the last one of `to`: shared components are relocated, those that `to` lacks end,
    /// those that only `to` has stay raw. The rows left behind are gaps until close_gaps(). Returns the
    /// first.
    std::uint32_t move(Archetype& from, std::span<const std::uint32_t> rows, Archetype& to) const noexcept;
    /// Ends the components, sparse ones too, and frees the handles of rows, which are gaps then.
    void end(Archetype& archetype, std::span<const std::uint32_t> rows) const noexcept;
    /// Fills gaps, from the lowest on, with the rows behind the new end, from the lowest on.
    /// @param fillers  scratch, as long as `gaps`
    void close_gaps(Archetype& archetype, std::span<const std::uint32_t> gaps,
                    std::span<std::uint32_t> fillers) const noexcept;

    /// move() and close_gaps() in one, where no other rows leave `from`: what a row leaves behind is filled
    /// while it is still in the cache.
    std::uint32_t move_and_close(Archetype& from, std::span<const std::uint32_t> rows, Archetype& to,
                                 std::span<std::uint32_t> fillers) const noexcept;
    /// The entities of rows that are behind the last yet, for send(); reserve() came before.
    static std::span<Entity> coming(Archetype& archetype, std::size_t count) noexcept {
        return {archetype.entities_ + archetype.rows_, count};
    }
    /// The same into places of the caller's choice: moves[i].row becomes number moves[i].command of those
    /// that come to `to`, whose entities and records the caller has written.
    /// @param moves  sorted by rows, with every number below moves.size() once
    void send(Archetype& from, std::span<const RowCommand> moves, Archetype& to,
              std::span<std::uint32_t> fillers) const noexcept;
    /// Makes sure that move_all() has room, and whether it may hand over whole columns. May fail.
    static void reserve_all(Archetype& from, Archetype& to);
    /// Moves all rows as move() does. Columns change hands where `to` is empty. Returns the first.
    std::uint32_t move_all(Archetype& from, Archetype& to) const noexcept;
    /// Ends all rows as end() does and leaves no gaps.
    void end_all(Archetype& archetype) const noexcept;
    /// Marks a column of these rows as written.
    void stamp_column(Archetype& archetype, ColumnIndex column, std::uint32_t first,
                      std::uint32_t end) const noexcept;

private:
    [[nodiscard]] static bool can_hand_over(const Archetype& from, const Archetype& to);
    static void hand_over(Archetype& from, Archetype& to) noexcept;
    /// The rows behind the new end that do not leave. Returns how many there are.
    template <class Rows>
    static std::size_t find_fillers(std::uint32_t old_end, const Rows& gaps,
                                    std::span<std::uint32_t> fillers) noexcept;
    /// Relocates rows and fills the gaps that they leave, column by column, the entities excepted.
    template <class Rows, class Place>
    void exchange_columns(Archetype& from, const Rows& rows, Archetype& to, std::uint32_t first,
                          std::span<const std::uint32_t> fillers, Place place) const noexcept;
    template <class Rows>
    void stamp_each(Archetype& archetype, const Rows& rows) const noexcept;
    /// Appends rows that the caller fills. Companions are zero, but for those that the rows bring with them.
    std::uint32_t grow_rows(Archetype& to, std::uint32_t count,
                            const Archetype* brought_from = nullptr) const noexcept;
    void stamp(Archetype& archetype, std::uint32_t first, std::uint32_t end) const noexcept;
};

}  // namespace rambla::ecs::detail
