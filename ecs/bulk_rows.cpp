#include "ecs/bulk_rows.h"

#include <algorithm>
#include <cstring>

#include "ecs/relocate.h"

namespace rambla::ecs::detail {
namespace {

/// How many entity records ahead of their turn are fetched: they lie anywhere.
constexpr std::size_t k_ahead = 32;

/// The same for rows of a column, which lie a little apart.
constexpr std::size_t k_rows_ahead = 64;

/// Copies rows of a size that the compiler knows; Width 0: of the size given.
template <std::size_t Width>
void gather(std::byte* to, const std::byte* from, std::span<const std::uint32_t> rows, std::size_t size) {
    for (std::uint32_t row : rows) {
        if constexpr (Width != 0) {
            std::memcpy(to, from + std::size_t{row} * Width, Width);
            to += Width;
        } else {
            copy_row(to, from + std::size_t{row} * size, size);
            to += size;
        }
    }
}

void gather(const Archetype::Column& column, std::byte* to, std::span<const std::uint32_t> rows) {
    if (!column.moves_by_bytes) {
        for (std::uint32_t row : rows) {
            column.info->relocate(to, column.at(row), 1);
            to += column.size;
        }
        return;
    }
    switch (column.size) {
        case 4:
            return gather<4>(to, column.base, rows, 4);
        case 8:
            return gather<8>(to, column.base, rows, 8);
        case 12:
            return gather<12>(to, column.base, rows, 12);
        case 16:
            return gather<16>(to, column.base, rows, 16);
        case 64:
            return gather<64>(to, column.base, rows, 64);
        default:
            return gather<0>(to, column.base, rows, column.size);
    }
}

template <class Row, class Rows>
void scatter(std::byte* base, const Rows& to, std::span<const std::uint32_t> from) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::memcpy(base + std::size_t{to[i]} * sizeof(Row), base + std::size_t{from[i]} * sizeof(Row),
                    sizeof(Row));
    }
}

struct Bytes12 {
    std::byte bytes[12];
};
struct Bytes16 {
    std::byte bytes[16];
};

/// Moves rows within a column, as many as there are fillers.
template <class Rows>
void fill_gaps(const Archetype::Column& column, const Rows& gaps, std::span<const std::uint32_t> fillers) {
    if (column.moves_by_bytes && column.size == 4) return scatter<std::uint32_t>(column.base, gaps, fillers);
    if (column.moves_by_bytes && column.size == 8) return scatter<std::uint64_t>(column.base, gaps, fillers);
    if (column.moves_by_bytes && column.size == 12) return scatter<Bytes12>(column.base, gaps, fillers);
    if (column.moves_by_bytes && column.size == 16) return scatter<Bytes16>(column.base, gaps, fillers);
    for (std::size_t i = 0; i < fillers.size(); ++i)
        column.relocate_row(column.at(gaps[i]), fillers[i]);
}

/// Copies row i of those listed out to place(i) and, as far as there are fillers, another row of the column
/// into its place.
template <class Row, class Rows, class Place>
void exchange(std::byte* to, std::byte* base, const Rows& rows, std::span<const std::uint32_t> fillers,
              Place place) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i + k_rows_ahead < rows.size()) {
            __builtin_prefetch(base + std::size_t{rows[i + k_rows_ahead]} * sizeof(Row), 1);
            __builtin_prefetch(to + place(i + k_rows_ahead) * sizeof(Row), 1);
        }
        std::byte* row = base + std::size_t{rows[i]} * sizeof(Row);
        std::memcpy(to + place(i) * sizeof(Row), row, sizeof(Row));
        if (i < fillers.size()) std::memcpy(row, base + std::size_t{fillers[i]} * sizeof(Row), sizeof(Row));
    }
}

template <class Rows, class Place>
void exchange(const Archetype::Column& column, std::byte* to, const Rows& rows,
              std::span<const std::uint32_t> fillers, Place place) {
    if (column.moves_by_bytes && column.size == 4)
        return exchange<std::uint32_t>(to, column.base, rows, fillers, place);
    if (column.moves_by_bytes && column.size == 8)
        return exchange<std::uint64_t>(to, column.base, rows, fillers, place);
    if (column.moves_by_bytes && column.size == 12)
        return exchange<Bytes12>(to, column.base, rows, fillers, place);
    if (column.moves_by_bytes && column.size == 16)
        return exchange<Bytes16>(to, column.base, rows, fillers, place);
    for (std::size_t i = 0; i < rows.size(); ++i)
        column.relocate_row(to + place(i) * column.size, rows[i]);
    fill_gaps(column, rows, fillers);
}

std::size_t in_order(std::size_t i) {
    return i;
}

template <class Rows>
void end_rows(const Archetype::Column& column, const Rows& rows) {
    if (column.info->destroy == nullptr) return;
    for (std::size_t i = 0; i < rows.size(); ++i)
        column.info->destroy(column.at(rows[i]), 1);
}

}  // namespace

void BulkRows::reserve(Archetype& archetype, std::uint64_t count) {
    archetype.reserve(archetype.rows() + count);
}

std::uint32_t BulkRows::create(Archetype& to, std::uint32_t count) const noexcept {
    if (count == 0) return to.rows_;
    const std::uint32_t first = grow_rows(to, count);
    for (std::uint32_t row = first; row < first + count; ++row)
        to.entities_[row] = entities.take(to.index(), row);
    return first;
}

std::uint32_t BulkRows::append(Archetype& to, std::span<const Entity> fresh) const noexcept {
    const std::uint32_t first = grow_rows(to, static_cast<std::uint32_t>(fresh.size()));
    std::ranges::copy(fresh, to.entities_ + first);
    for (std::uint32_t i = 0; i < fresh.size(); ++i)
        entities.place(fresh[i].index, to.index(), first + i);
    return first;
}

std::uint32_t BulkRows::move(Archetype& from, std::span<const std::uint32_t> rows,
                             Archetype& to) const noexcept {
    const std::uint32_t first = grow_rows(to, static_cast<std::uint32_t>(rows.size()));
    Entity* moved = to.entities_ + first;
    for (std::size_t i = 0; i < rows.size(); ++i)
        moved[i] = from.entities_[rows[i]];
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i + k_ahead < rows.size()) entities.prefetch(moved[i + k_ahead].index);
        entities.place(moved[i].index, to.index(), first + static_cast<std::uint32_t>(i));
    }
    auto target = to.columns_.begin();
    for (const Archetype::Column& source : from.columns_) {
        while (target != to.columns_.end() && target->component < source.component)
            ++target;
        if (target != to.columns_.end() && target->component == source.component) {
            gather(source, target->at(first), rows);
        } else {
            end_rows(source, rows);
        }
    }
    return first;
}

void BulkRows::end(Archetype& archetype, std::span<const std::uint32_t> rows) const noexcept {
    for (const Archetype::Column& column : archetype.columns_)
        end_rows(column, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i + k_ahead < rows.size()) entities.prefetch(archetype.entities_[rows[i + k_ahead]].index);
        const Entity ended = archetype.entities_[rows[i]];
        sparse.erase_all(ended, version);
        entities.give_back(ended.index);
    }
}

std::uint32_t BulkRows::move_and_close(Archetype& from, std::span<const std::uint32_t> rows, Archetype& to,
                                       std::span<std::uint32_t> fillers) const noexcept {
    const std::uint32_t first = grow_rows(to, static_cast<std::uint32_t>(rows.size()));
    const std::uint32_t old_end = from.rows_;
    fillers = fillers.first(find_fillers(old_end, rows, fillers));
    Entity* moved = to.entities_ + first;
    exchange<Entity>(reinterpret_cast<std::byte*>(moved), reinterpret_cast<std::byte*>(from.entities_), rows,
                     fillers, in_order);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i + k_ahead < rows.size()) entities.prefetch(moved[i + k_ahead].index);
        entities.place(moved[i].index, to.index(), first + static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < fillers.size(); ++i) {
        if (i + k_ahead < fillers.size()) entities.prefetch(from.entities_[fillers[i + k_ahead]].index);
        entities[from.entities_[fillers[i]].index].row = rows[i];
    }
    exchange_columns(from, rows, to, first, fillers, in_order);
    return first;
}

void BulkRows::send(Archetype& from, std::span<const RowCommand> moves, Archetype& to,
                    std::span<std::uint32_t> fillers) const noexcept {
    const RowsOf rows{moves};
    const std::uint32_t first = grow_rows(to, static_cast<std::uint32_t>(rows.size()));
    fillers = fillers.first(find_fillers(from.rows_, rows, fillers));
    for (std::size_t i = 0; i < fillers.size(); ++i) {
        if (i + k_ahead < fillers.size()) entities.prefetch(from.entities_[fillers[i + k_ahead]].index);
        if (i + k_rows_ahead < fillers.size()) __builtin_prefetch(from.entities_ + rows[i + k_rows_ahead], 1);
        const Entity filler = from.entities_[fillers[i]];
        from.entities_[rows[i]] = filler;
        entities[filler.index].row = rows[i];
    }
    exchange_columns(from, rows, to, first, fillers,
                     [&](std::size_t i) -> std::size_t { return moves[i].command; });
}

template <class Rows, class Place>
void BulkRows::exchange_columns(Archetype& from, const Rows& rows, Archetype& to, std::uint32_t first,
                                std::span<const std::uint32_t> fillers, Place place) const noexcept {
    for (const Archetype::Column& source : from.columns_) {
        const ColumnIndex target = to.column_of(source.component);
        if (target != k_no_column) {
            exchange(source, to.columns_[target].at(first), rows, fillers, place);
        } else {
            end_rows(source, rows);
            fill_gaps(source, rows, fillers);
        }
    }
    const std::uint32_t old_end = from.rows_;
    from.rows_ = old_end - static_cast<std::uint32_t>(rows.size());
    stamp_each(from, rows.first(fillers.size()));
    stamp(from, from.rows_, old_end);
}

template <class Rows>
std::size_t BulkRows::find_fillers(std::uint32_t old_end, const Rows& gaps,
                                   std::span<std::uint32_t> fillers) noexcept {
    const std::uint32_t end = old_end - static_cast<std::uint32_t>(gaps.size());
    std::size_t next_gap = gaps.size();
    while (next_gap != 0 && gaps[next_gap - 1] >= end)
        --next_gap;
    std::size_t count = 0;
    for (std::uint32_t row = end; row < old_end; ++row) {
        if (next_gap != gaps.size() && gaps[next_gap] == row) {
            ++next_gap;
        } else {
            fillers[count++] = row;
        }
    }
    return count;
}

void BulkRows::close_gaps(Archetype& archetype, std::span<const std::uint32_t> gaps,
                          std::span<std::uint32_t> fillers) const noexcept {
    if (gaps.empty()) return;
    const std::uint32_t old_end = archetype.rows_;
    fillers = fillers.first(find_fillers(old_end, gaps, fillers));
    const std::span<const std::uint32_t> holes = gaps.first(fillers.size());
    archetype.rows_ = old_end - static_cast<std::uint32_t>(gaps.size());
    for (const Archetype::Column& column : archetype.columns_)
        fill_gaps(column, holes, fillers);
    for (std::size_t i = 0; i < fillers.size(); ++i) {
        if (i + k_ahead < fillers.size()) entities.prefetch(archetype.entities_[fillers[i + k_ahead]].index);
        const Entity filler = archetype.entities_[fillers[i]];
        archetype.entities_[holes[i]] = filler;
        entities[filler.index].row = holes[i];
    }
    stamp_each(archetype, holes);
    stamp(archetype, archetype.rows_, old_end);
}

template <class Rows>
void BulkRows::stamp_each(Archetype& archetype, const Rows& rows) const noexcept {
    std::uint32_t next_chunk = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::uint32_t row = rows[i];
        if (row / k_chunk_rows < next_chunk) continue;
        archetype.stamp_rows(row, version);
        next_chunk = row / k_chunk_rows + 1;
    }
}

bool BulkRows::can_hand_over(const Archetype& from, const Archetype& to) {
    return to.rows_ == 0 && !from.reserved_.empty();
}

void BulkRows::reserve_all(Archetype& from, Archetype& to) {
    if (!can_hand_over(from, to)) return to.reserve(std::uint64_t{to.rows_} + from.rows_);
    to.reserve(k_pooled_rows + std::uint64_t{1});  // so that it has reservations of its own
    if (to.reserved_.empty()) return to.reserve(from.rows_);
    to.reserve_versions(from.capacity_);
    for (std::size_t i = 0; i < to.columns_.size(); ++i) {
        if (from.has(to.columns_[i].component)) continue;
        to.reserved_[i + 1].commit(to.begin_in_reserved(i + 1) +
                                   std::size_t{from.capacity_} * to.columns_[i].size);
    }
}

std::uint32_t BulkRows::move_all(Archetype& from, Archetype& to) const noexcept {
    const std::uint32_t count = from.rows_;
    const std::uint32_t first = to.rows_;
    const bool hands_over = can_hand_over(from, to) && !to.reserved_.empty();
    if (hands_over) hand_over(from, to);
    grow_rows(to, count, &from);
    if (!hands_over) std::copy_n(from.entities_, count, to.entities_ + first);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i + k_ahead < count) entities.prefetch(to.entities_[first + i + k_ahead].index);
        entities.place(to.entities_[first + i].index, to.index(), first + i);
    }
    for (const Archetype::Column& source : from.columns_) {
        const ColumnIndex target = to.column_of(source.component);
        if (target == k_no_column) {
            destroy_rows(*source.info, source.base, count);
        } else if (!hands_over && count != 0) {
            relocate_rows(*source.info, to.columns_[target].at(first), source.base, count);
        }
    }
    stamp(from, 0, count);
    from.rows_ = 0;
    return first;
}

void BulkRows::hand_over(Archetype& from, Archetype& to) noexcept {
    const std::uint32_t capacity = from.capacity_;
    std::swap(from.reserved_[0], to.reserved_[0]);
    std::swap(from.entities_, to.entities_);
    for (std::size_t i = 0; i < from.columns_.size(); ++i) {
        const ColumnIndex target = to.column_of(from.columns_[i].component);
        if (target == k_no_column) continue;
        std::swap(from.reserved_[i + 1], to.reserved_[target + std::size_t{1}]);
        std::swap(from.columns_[i].base, to.columns_[target].base);
    }
    // What `from` got is as long as it was in `to`; what it kept may be longer or shorter.
    from.capacity_ = std::min(from.capacity_, to.capacity_);
    to.capacity_ = capacity;
}

void BulkRows::end_all(Archetype& archetype) const noexcept {
    const std::uint32_t count = archetype.rows_;
    for (const Archetype::Column& column : archetype.columns_) {
        if (count != 0) destroy_rows(*column.info, column.base, count);
    }
    for (std::uint32_t row = 0; row < count; ++row) {
        if (row + k_ahead < count) entities.prefetch(archetype.entities_[row + k_ahead].index);
        sparse.erase_all(archetype.entities_[row], version);
        entities.give_back(archetype.entities_[row].index);
    }
    stamp(archetype, 0, count);
    archetype.rows_ = 0;
}

void BulkRows::stamp_column(Archetype& archetype, ColumnIndex column, std::uint32_t first,
                            std::uint32_t end) const noexcept {
    for (std::uint32_t row = first; row < end; row = (row / k_chunk_rows + 1) * k_chunk_rows)
        archetype.stamp(column, row / k_chunk_rows, version);
}

std::uint32_t BulkRows::grow_rows(Archetype& to, std::uint32_t count,
                                  const Archetype* brought_from) const noexcept {
    const std::uint32_t first = to.rows_;
    to.rows_ += count;
    stamp(to, first, to.rows_);
    if (!to.has_companions_) return first;
    for (const Archetype::Column& column : to.columns_) {
        if (!column.info->is_companion) continue;
        if (brought_from != nullptr && brought_from->has(column.component)) continue;
        std::memset(column.at(first), 0, std::size_t{count} * column.size);
    }
    return first;
}

void BulkRows::stamp(Archetype& archetype, std::uint32_t first, std::uint32_t end) const noexcept {
    for (std::uint32_t row = first; row < end; row = (row / k_chunk_rows + 1) * k_chunk_rows)
        archetype.stamp_rows(row, version);
}

}  // namespace rambla::ecs::detail
