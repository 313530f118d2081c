#include "ecs/alike_moves.h"

#include <algorithm>

#include "ecs/misuse.h"
#include "ecs/relocate.h"

namespace rambla::ecs::detail {
namespace {

/// How many entity records ahead of their turn are fetched: they lie anywhere.
constexpr std::size_t k_ahead = 32;

std::size_t count_commands(std::span<const CommandRun> runs) {
    std::size_t count = 0;
    for (const CommandRun& run : runs)
        count += run.count;
    return count;
}

void copy_entities(std::span<const CommandRun> runs, Entity* to) {
    for (const CommandRun& run : runs) {
        if (run.entity_stride == sizeof(Entity)) {
            to = std::copy_n(run.first_entity, run.count, to);
        } else {
            for (std::size_t i = 0; i < run.count; ++i)
                *to++ = run.entity(i);
        }
    }
}

/// Moves the values into rows that are raw memory, from `row` on.
void take_values(std::span<const CommandRun> runs, const Archetype::Column& column, std::uint32_t row) {
    for (const CommandRun& run : runs) {
        relocate_rows(*column.info, column.at(row), run.first_value, run.count);
        row += static_cast<std::uint32_t>(run.count);
    }
}

}  // namespace

bool AlikeMoves::play(ArchetypeGraph& graph, const BulkRows& bulk, const CommandType& type,
                      std::span<const CommandRun> runs) {
    const bool adds = type.kind == CommandKind::add;
    const EntityRecord* first = bulk.entities.find(*runs[0].first_entity);
    if (first == nullptr) return false;
    Archetype& from = graph[first->archetype];
    const ComponentId component = graph.component(*type.parts[0].info);
    if (from.has(component) == adds) return adds && replace(from, component, bulk, runs);

    Archetype& to = graph.toggled(from, component);
    const std::uint32_t first_row = to.rows();
    const std::size_t count = count_commands(runs);
    if (!reserve(to, count)) return false;
    const std::span<Entity> entities = BulkRows::coming(to, count);
    copy_entities(runs, entities.data());
    if (!send_records(from, to, entities, bulk.entities)) return false;
    const ColumnIndex column = to.column_of(component);
    if (adds && column != k_tag_column) take_values(runs, to.columns()[column], first_row);
    sort_by_row(items_, scratch_, highest_row_);
    bulk.send(from, items_, to, fillers_);
    return true;
}

bool AlikeMoves::replace(Archetype& archetype, ComponentId component, const BulkRows& bulk,
                         std::span<const CommandRun> runs) {
    const ColumnIndex index = archetype.column_of(component);
    if (index == k_tag_column) return false;
    targets_.resize(count_commands(runs));
    copy_entities(runs, targets_.data());
    if (!find_rows(archetype, bulk.entities)) return false;
    const Archetype::Column& column = archetype.columns()[index];
    std::size_t next = 0;
    for (const CommandRun& run : runs) {
        std::byte* value = run.first_value;
        for (const std::size_t end = next + run.count; next < end; ++next, value += column.size) {
            if (next + k_ahead < rows_.size()) __builtin_prefetch(column.at(rows_[next + k_ahead]), 1);
            destroy_rows(*column.info, column.at(rows_[next]), 1);
            column.take_row(rows_[next], value);
            archetype.stamp_row(index, rows_[next], bulk.version);
        }
    }
    return true;
}

bool AlikeMoves::find_rows(const Archetype& archetype, const EntityTable& table) {
    rows_.resize(targets_.size());
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        if (i + k_ahead < targets_.size()) table.prefetch(targets_[i + k_ahead]);
        const EntityRecord* const record = table.find(targets_[i]);
        if (record == nullptr || record->archetype != archetype.index()) return false;
        rows_[i] = record->row;
    }
    return true;
}

bool AlikeMoves::reserve(Archetype& to, std::size_t count) {
    try {
        BulkRows::reserve(to, count);
    } catch (const CapacityExceeded&) {
        return false;
    }
    items_.resize(count);
    scratch_.resize(count);
    fillers_.resize(count);
    return true;
}

bool AlikeMoves::send_records(const Archetype& from, const Archetype& to, std::span<const Entity> entities,
                              EntityTable& table) noexcept {
    const std::uint32_t from_index = from.index();
    const std::uint32_t to_index = to.index();
    const std::uint32_t first_row = to.rows();
    std::uint32_t highest_row = 0;
    for (std::uint32_t i = 0; i < entities.size(); ++i) {
        if (i + k_ahead < entities.size()) table.prefetch(entities[i + k_ahead]);
        EntityRecord* const record = table.find(entities[i]);
        // An entity that came before is in `to` already.
        if (record == nullptr || record->archetype != from_index) {
            for (std::uint32_t sent = 0; sent < i; ++sent)
                table.place(entities[sent].index, from_index, items_[sent].row);
            return false;
        }
        items_[i] = {record->row, i};
        highest_row = std::max(highest_row, record->row);
        record->archetype = to_index;
        record->row = first_row + i;
    }
    highest_row_ = highest_row;
    return true;
}

std::size_t AlikeMoves::memory_bytes() const {
    return (items_.capacity() + scratch_.capacity()) * sizeof(RowCommand) +
           targets_.capacity() * sizeof(Entity) +
           (rows_.capacity() + fillers_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace rambla::ecs::detail
