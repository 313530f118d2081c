#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "ecs/snapshot.h"
#include "ecs/type_registry.h"
#include "property/ecs/model.h"
#include "property/ecs/queries.h"
#include "property/ecs/reflected_parts.h"

namespace rambla::ecs::property {

/// A second world that follows a first one through snapshots and deltas of it.
class Replica {
public:
    /// Brings it up to date, and compares it. Throws Disagreement.
    void follow(World& world, const Model& model, bool by_delta) {
        if (!restored_ || !by_delta) {
            restored_ = read_snapshot(writer_.write(world), registry_);
        } else {
            apply_delta(*restored_, writer_.write_delta(world), registry_);
        }
        expect(restored_->position == writer_.position(), "a replica stands where its writer does");
        expect(restored_->world->entity_count() == world.entity_count(), "a replica has as many entities");
        expect(order_of(*restored_->world) == order_of(world), "a replica has its rows in the same order");
        Model expected = model;
        for (auto& [key, entity] : expected.entities())
            forget_transient(entity);
        queries_.check_all(*restored_->world, expected);
        for (const Entity entity : model.dead())
            expect(!restored_->world->alive(entity), "a dead entity lives in a replica");
    }

    /// A snapshot of either world, up to date, has the same bytes. Begins a new chain.
    void compare_bytes(World& world) {
        SnapshotWriter replicas{registry_};
        const std::span<const std::byte> found = replicas.write(*restored_->world);
        const std::span<const std::byte> expected = writer_.write(world);
        expect(std::ranges::equal(found, expected), "a replica's snapshot has other bytes");
        restored_ = read_snapshot(expected, registry_);
    }
    /// May come at any time, as it changes no value.
    void compact() {
        if (restored_) restored_->world->compact();
    }

private:
    static std::uint64_t order_of(const World& world) {
        std::uint64_t hash = 0xcbf29ce484222325u;
        Query<Entity> all;
        all.each(world, [&](Entity entity) { hash = (hash ^ key_of(entity)) * 0x100000001b3u; });
        return hash;
    }
    static void forget_transient(ModelEntity& entity) {
        const auto reset = [&]<class C>() {
            if (entity.has(part_number<C>())) entity.parts[part_number<C>()] = read_part(C{});
        };
        reset.operator()<Anchored>();
        reset.operator()<Owner>();
        reset.operator()<Line>();
        reset.operator()<Ticket>();
        reset.operator()<SparseAnchored>();
    }

    TypeRegistry registry_ = parts_registry();
    SnapshotWriter writer_{registry_};
    std::optional<RestoredWorld> restored_;
    Queries queries_;
};

}  // namespace rambla::ecs::property
