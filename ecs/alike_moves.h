#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecs/archetype_graph.h"
#include "ecs/bulk_rows.h"
#include "ecs/command_list.h"
#include "ecs/row_sort.h"

namespace rambla::ecs::detail {

/// The commonest long recording: one component given to, or taken from, many different entities of one
/// archetype, or its value replaced there. Needs no plan. Entities arrive in the order of the commands, so
/// that each record is visited once and values are read and written one behind the other; only what lies in
/// the archetype is visited by rows.
class AlikeMoves {
public:
    /// Fewer commands gain nothing.
    static constexpr std::size_t k_fewest = 32;

    /// Plays commands of one type if they are of that kind. Else changes nothing and says no; the same where
    /// memory is short.
    /// @param type  one that is_about_one_column()
    /// @param runs  at least one
    [[nodiscard]] bool play(ArchetypeGraph& graph, const BulkRows& bulk, const CommandType& type,
                            std::span<const CommandRun> runs);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// Gives new values to entities that stay where they are.
    [[nodiscard]] bool replace(Archetype& archetype, ComponentId component, const BulkRows& bulk,
                               std::span<const CommandRun> runs);
    /// The rows of targets_, if all are in this archetype.
    [[nodiscard]] bool find_rows(const Archetype& archetype, const EntityTable& table);
    [[nodiscard]] bool reserve(Archetype& to, std::size_t count);
    /// Points the records of entities to rows behind the last of `to`. Undone if it finds one that does not
    /// fit.
    [[nodiscard]] bool send_records(const Archetype& from, const Archetype& to,
                                    std::span<const Entity> entities, EntityTable& table) noexcept;

    std::vector<RowCommand> items_;
    std::vector<RowCommand> scratch_;
    std::vector<std::uint32_t> fillers_;
    std::vector<Entity> targets_;  ///< of values that are replaced, and their rows
    std::vector<std::uint32_t> rows_;
    std::uint32_t highest_row_ = 0;
};

}  // namespace rambla::ecs::detail
