#include "ecs/alike_moves.h"

#include <algorithm>

#include "ecs/misuse.h"

namespace rambla::ecs::detail {
namespace {

/// How many entity records ahead of their turn are fetched: they lie anywhere.
constexpr std::size_t k_ahead = 32;

}  // namespace

bool AlikeMoves::play(ArchetypeGraph& graph, const BulkRows& bulk, std::span<const Command> commands) {
    const CommandType& type = *commands[0].type;
    const bool adds = type.kind == CommandKind::add;
    if ((!adds && type.kind != CommandKind::remove) || type.beside_columns || type.holds_entities)
        return false;
    const EntityRecord* first = bulk.entities.find(commands[0].entity);
    if (first == nullptr) return false;
    Archetype& from = graph[first->archetype];
    const ComponentId component = graph.component(*type.parts[0].info);
    if (from.has(component) == adds) return false;

    Archetype& to = graph.toggled(from, component);
    const std::uint32_t first_row = to.rows();
    if (!reserve(to, commands.size())) return false;
    const ColumnIndex index = to.column_of(component);
    const Archetype::Column* const column = adds && index != k_tag_column ? &to.columns()[index] : nullptr;
    if (!send_records(from, to, column, bulk.entities, commands)) return false;
    sort_by_row(items_, scratch_, highest_row_);
    bulk.send(from, items_, to, fillers_);
    if (column == nullptr || column->moves_by_bytes) return true;
    for (std::uint32_t i = 0; i < commands.size(); ++i)
        column->take_row(first_row + i, commands[i].values);
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

bool AlikeMoves::send_records(const Archetype& from, Archetype& to, const Archetype::Column* column,
                              EntityTable& entities, std::span<const Command> commands) noexcept {
    const bool copies = column != nullptr && column->moves_by_bytes;
    const std::uint32_t first_row = to.rows();
    highest_row_ = 0;
    for (std::uint32_t i = 0; i < commands.size(); ++i) {
        if (i + k_ahead < commands.size()) entities.prefetch(commands[i + k_ahead].entity);
        EntityRecord* const record = entities.find(commands[i].entity);
        // An entity that came before is in `to` already.
        if (record == nullptr || record->archetype != from.index()) {
            undo(from, entities, commands.first(i));
            return false;
        }
        items_[i] = {record->row, i};
        highest_row_ = std::max(highest_row_, record->row);
        record->archetype = to.index();
        record->row = first_row + i;
        BulkRows::set_entity(to, first_row + i, commands[i].entity);
        if (copies) column->take_row(first_row + i, commands[i].values);
    }
    return true;
}

void AlikeMoves::undo(const Archetype& from, EntityTable& entities,
                      std::span<const Command> commands) noexcept {
    for (std::size_t i = 0; i < commands.size(); ++i)
        entities.place(commands[i].entity.index, from.index(), items_[i].row);
}

std::size_t AlikeMoves::memory_bytes() const {
    return (items_.capacity() + scratch_.capacity()) * sizeof(RowCommand) +
           fillers_.capacity() * sizeof(std::uint32_t);
}

}  // namespace rambla::ecs::detail
