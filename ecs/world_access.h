#pragma once

#include <cstddef>
#include <cstdint>

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
        while (archetype.capacity_ < rows)
            archetype.grow();
    }
    static void set_rows(Archetype& archetype, std::uint32_t rows) { archetype.rows_ = rows; }
    static Entity* entities(Archetype& archetype) { return archetype.entities_; }

    static constexpr std::uint32_t k_no_slot = EntityTable::k_none;
    static constexpr std::uint32_t k_last_generation = 0xffffffffu;
    static std::uint32_t slots(const EntityTable& table) { return table.size_; }
    static std::uint32_t max_slots(const EntityTable& table) { return table.max_entities_; }
    static std::uint32_t first_free(const EntityTable& table) { return table.first_free_; }
    static const EntityRecord& record(const EntityTable& table, std::uint32_t index) {
        return table.records()[index];
    }
    static void reserve(EntityTable& table, std::uint32_t slots) {
        while (table.capacity_ < slots)
            table.grow();
    }
    static void set_slots(EntityTable& table, std::uint32_t slots, std::uint32_t alive) {
        table.size_ = slots;
        table.alive_ = alive;
    }
    static void set_first_free(EntityTable& table, std::uint32_t index) { table.first_free_ = index; }
};

}  // namespace rambla::ecs::detail
