#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "ecs/version.h"
#include "ecs/world.h"

namespace rambla::ecs::detail {

/// The inside of a world, for what reads or rebuilds it as a whole.
struct WorldAccess {
    static ArchetypeGraph& graph(World& world) { return world.graph_; }
    static const ArchetypeGraph& graph(const World& world) { return world.graph_; }
    static EntityTable& entities(World& world) { return world.entities_; }
    static const EntityTable& entities(const World& world) { return world.entities_; }
    static Resources& resources(World& world) { return world.resources_; }
    static const Resources& resources(const World& world) { return world.resources_; }
    static std::uint64_t serial(const World& world) { return world.serial_; }
    /// Goes on to a later version.
    static void set_version(World& world, std::uint32_t version) {
        const bool ages = version / World::k_aging_interval != world.version_ / World::k_aging_interval;
        world.version_ = version;
        if (ages) world.age_versions();
    }

    static std::uint32_t max_rows(const ArchetypeGraph& graph) { return graph.storage_.max_rows; }

    /// Version at which rows of a chunk came or went last.
    static std::uint32_t rows_version(const Archetype& archetype, std::uint32_t chunk) {
        return archetype.versions_[chunk * archetype.version_stride()];
    }
    static void stamp_rows(Archetype& archetype, std::uint32_t row, std::uint32_t version) {
        archetype.stamp_rows(row, version);
    }
    static void reserve(Archetype& archetype, std::uint32_t rows) {
        if (archetype.capacity_ < rows) archetype.grow_to(rows);
    }
    static void set_rows(Archetype& archetype, std::uint32_t rows) { archetype.rows_ = rows; }
    static Entity* entities(Archetype& archetype) { return archetype.entities_; }

    static BlockPool& pool(ArchetypeGraph& graph) { return graph.storage_.pool; }
    /// Exchanges what two sets of the same component and pool hold.
    static void swap(SparseSet& a, SparseSet& b) noexcept {
        a.pages_.swap(b.pages_);
        a.entities_.swap(b.entities_);
        a.versions_.swap(b.versions_);
        a.values_.swap(b.values_);
        std::swap(a.membership_version_, b.membership_version_);
    }
    /// Whether a value was written, came or went after `version`.
    static bool changed_since(const SparseSet& set, std::uint32_t version) {
        return is_after(set.membership_version_, version) ||
               std::any_of(set.versions_.begin(), set.versions_.end(),
                           [&](std::uint32_t written) { return is_after(written, version); });
    }
    static void set_membership_version(SparseSet& set, std::uint32_t version) {
        set.membership_version_ = version;
    }

    static constexpr std::uint32_t k_no_slot = EntityTable::k_none;
    static constexpr std::uint32_t k_last_generation = EntityTable::k_last_generation;
    static std::uint32_t slots(const EntityTable& table) { return table.size_; }
    static std::uint32_t max_slots(const EntityTable& table) { return table.max_entities_; }
    static std::uint32_t first_free(const EntityTable& table) { return table.first_free_; }
    static const EntityRecord& record(const EntityTable& table, std::uint32_t index) {
        return table.records()[index];
    }
    static std::uint32_t retired(const EntityTable& table) { return table.retired_; }
    static void reserve(EntityTable& table, std::uint32_t slots) {
        if (table.capacity_ < slots) table.grow_to(slots);
    }
    static void set_slots(EntityTable& table, std::uint32_t slots, std::uint32_t alive,
                          std::uint32_t retired) {
        table.size_ = slots;
        table.alive_ = alive;
        table.retired_ = retired;
    }
    static void set_first_free(EntityTable& table, std::uint32_t index) { table.first_free_ = index; }
};

}  // namespace rambla::ecs::detail
