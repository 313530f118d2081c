#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "ecs/archetype_graph.h"
#include "ecs/command.h"
#include "ecs/entity_table.h"
#include "ecs/row_sort.h"

namespace rambla::ecs::detail {

/// A value that a row gets.
struct PlannedWrite {
    std::byte* value;
    const ComponentInfo* info;
    ComponentId component;
};

/// A value that no row gets, because a later command took its place.
struct ObsoleteValue {
    std::byte* value;
    const ComponentInfo* info;
};

/// A sparse value that comes, takes the place of another, or goes.
struct PlannedSparse {
    Entity entity;  ///< a placeholder for those that are created
    std::byte* value;
    const ComponentInfo* info;
    bool removes;
};

/// Where the writes of one row are in the list of all.
struct WriteRange {
    std::uint32_t first;
    std::uint32_t count;
};

/// Rows of one archetype that have the same fate. Created entities have their numbers for rows.
struct PlannedGroup {
    Archetype* from;  ///< null for created entities
    Archetype* to;    ///< null where they end; `from` where they stay and get values
    std::uint32_t first;
    std::uint32_t count;
    /// Set where each row gets one value, of this component; then they are in values() instead of writes().
    const ComponentInfo* only = nullptr;
    ComponentId component = k_no_component;
    std::uint32_t first_value = 0;
};

/// The rows of one archetype that leave it.
struct PlannedGaps {
    Archetype* archetype;
    std::uint32_t first;
    std::uint32_t count;
};

/// What a list of commands comes down to: all commands of one entity folded into one fate, entities with the
/// same fate in groups. Making a plan changes neither the world's entities nor the recorded values; it may
/// give birth to archetypes.
class CommandPlan {
public:
    /// @param created  what placeholders below its size stand for; those above are created by these commands
    void make(ArchetypeGraph& graph, const EntityTable& entities, std::span<const Command> commands,
              CreatedEntities created);

    /// By the age of the archetype that rows come from, created entities last.
    [[nodiscard]] std::span<const PlannedGroup> groups() const { return groups_; }
    [[nodiscard]] std::span<const PlannedGaps> gaps() const { return gaps_; }
    [[nodiscard]] std::span<const std::uint32_t> rows(const PlannedGroup& group) const {
        return std::span{rows_}.subspan(group.first, group.count);
    }
    [[nodiscard]] std::span<const WriteRange> write_ranges(const PlannedGroup& group) const {
        return std::span{ranges_}.subspan(group.first, group.count);
    }
    [[nodiscard]] std::span<const PlannedWrite> writes() const { return writes_; }
    /// Of a group in which each row gets one value of the same component.
    [[nodiscard]] std::span<std::byte* const> values(const PlannedGroup& group) const {
        return std::span{values_}.subspan(group.first_value, group.count);
    }
    /// Ascending.
    [[nodiscard]] std::span<const std::uint32_t> rows(const PlannedGaps& gaps) const {
        return std::span{gap_rows_}.subspan(gaps.first, gaps.count);
    }
    /// In the order of the rows that they belong to, those of created entities last.
    [[nodiscard]] std::span<const PlannedSparse> sparse() const { return sparse_; }
    [[nodiscard]] std::span<const ObsoleteValue> obsolete() const { return obsolete_; }
    /// Commands that were create().
    [[nodiscard]] std::uint32_t creations() const { return creations_; }
    [[nodiscard]] std::size_t dropped() const { return dropped_; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// The commands about the rows of one archetype.
    struct Section {
        std::uint32_t archetype;  ///< graph_->size() for created entities
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        std::uint32_t highest_row = 0;
        bool sorted = true;
    };
    /// Where an entity ends up: null if it ends.
    struct Fate {
        Archetype* to;
    };
    /// What the last entity with a single command came down to: mostly the next is the same.
    struct Repeat {
        const CommandType* type = nullptr;
        Archetype* to = nullptr;
        const ComponentInfo* written = nullptr;
        ComponentId component = k_no_component;
        bool drops = false;
    };

    void clear();
    void find_rows(const EntityTable& entities, CreatedEntities created);
    /// Folds a section whose commands are all of one type and about different rows. Returns whether it was.
    bool fold_alike(const Section& section, Archetype& from);
    void put(std::uint32_t section_key, std::uint32_t row, std::uint32_t command);
    void sort_by_section();
    void fold(const Section& section);
    Repeat fate_of_one(Archetype& from, const CommandType& type);
    Fate fold_single(Archetype& from, const Command& command, Repeat& repeat);
    Fate fold_run(Archetype* from, std::span<const RowCommand> run);
    void fold_sparse(Entity entity, const Command& command, const CommandPart& part,
                     std::size_t first_sparse);
    [[nodiscard]] bool holds_sparse(Entity entity, const ComponentInfo& info, std::size_t first_sparse) const;
    void drop(const Command& command);
    void set(const PlannedWrite& write, std::size_t first_write);
    void unset(ComponentId component, std::size_t first_write);
    void forget(std::byte* value, const ComponentInfo& info);
    Archetype& bundle(const CommandType& type);
    Archetype& toggled(Archetype& from, ComponentId component);
    std::uint32_t group_to(Archetype* from, Archetype* to);
    void group_rows(std::uint32_t first_row);

    ArchetypeGraph* graph_ = nullptr;
    std::span<const Command> commands_;
    std::vector<RowCommand> items_;
    std::vector<std::uint32_t> section_of_item_;
    std::vector<RowCommand> scratch_items_;
    std::vector<Section> sections_;
    std::vector<std::uint32_t> section_order_;
    std::vector<std::uint32_t> section_of_archetype_;  ///< 1 + place in sections_, 0 for none
    std::vector<PlannedGroup> groups_;
    std::vector<std::uint32_t> group_of_archetype_;  ///< 1 + place among the section's groups, 0 for none
    std::vector<PlannedGaps> gaps_;
    std::vector<std::uint32_t> rows_;
    std::vector<WriteRange> ranges_;
    std::vector<std::uint32_t> group_of_row_;
    std::vector<std::uint32_t> scratch_rows_;
    std::vector<WriteRange> scratch_ranges_;
    std::vector<std::uint32_t> gap_rows_;
    std::vector<PlannedWrite> writes_;
    std::vector<std::byte*> values_;
    std::vector<PlannedSparse> sparse_;
    std::vector<ObsoleteValue> obsolete_;
    std::unordered_map<const CommandType*, Archetype*> bundles_;
    const CommandType* bundle_type_ = nullptr;  ///< asked for last, and its archetype
    Archetype* bundle_ = nullptr;
    std::vector<ComponentId> signature_;
    std::size_t dropped_ = 0;
    std::uint32_t creations_ = 0;
    std::uint32_t section_key_ = 0;    ///< of the command put last
    std::uint32_t section_place_ = 0;  ///< 1 + place in sections_; 0 before the first
    bool alike_ = true;                ///< all commands are of one type
    std::uint32_t archetypes_before_ = 0;
    std::uint32_t section_first_group_ = 0;
    Archetype* toggled_from_ = nullptr;  ///< the step taken last, and where it led
    Archetype* toggled_to_ = nullptr;
    ComponentId toggled_component_ = k_no_component;
};

}  // namespace rambla::ecs::detail
