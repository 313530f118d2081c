#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecs/archetype_graph.h"
#include "ecs/bulk_rows.h"
#include "ecs/command.h"
#include "ecs/row_sort.h"

namespace rambla::ecs::detail {

/// The commonest long recording: one component given to, or taken from, many different entities of one
/// archetype. Needs no plan. Entities arrive in the order of the commands, so that each record is visited
/// once and values are read and written one behind the other; only what lies in the archetype is visited by
/// rows.
class AlikeMoves {
public:
    /// Fewer commands gain nothing.
    static constexpr std::size_t k_fewest = 32;

    /// Plays commands of one type if they are of that kind. Else changes nothing and says no; the same where
    /// memory is short.
    [[nodiscard]] bool play(ArchetypeGraph& graph, const BulkRows& bulk, std::span<const Command> commands);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    [[nodiscard]] bool reserve(Archetype& to, std::size_t count);
    /// Points the records of all entities to their new rows, and copies values there that move by their
    /// bytes. Undone if it finds one that does not fit.
    /// @param column  that the values are for, null where there are none
    [[nodiscard]] bool send_records(const Archetype& from, Archetype& to, const Archetype::Column* column,
                                    EntityTable& entities, std::span<const Command> commands) noexcept;
    void undo(const Archetype& from, EntityTable& entities, std::span<const Command> commands) noexcept;

    std::vector<RowCommand> items_;
    std::vector<RowCommand> scratch_;
    std::vector<std::uint32_t> fillers_;
    std::uint32_t highest_row_ = 0;
};

}  // namespace rambla::ecs::detail
