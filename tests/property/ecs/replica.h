#pragma once

#include <cstdint>
#include <optional>

#include "ecs/snapshot.h"
#include "ecs/type_registry.h"
#include "property/ecs/model.h"
#include "property/ecs/queries.h"
#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {

template <>
struct reflection<test::Hidden> {
    static constexpr auto value = describe<test::Hidden>("hidden");
};
template <>
struct reflection<test::Selected> {
    static constexpr auto value = describe<test::Selected>("selected");
};
template <>
struct reflection<test::Light> {
    static constexpr auto value = describe<test::Light>("light").field("lux", &test::Light::lux);
};
template <>
struct reflection<test::Burning> {
    static constexpr auto value = describe<test::Burning>("burning").field("heat", &test::Burning::heat);
};

}  // namespace rambla::ecs

namespace rambla::ecs::property {

/// A second world that follows a first one through snapshots and deltas of it.
class Replica {
public:
    Replica() {
        registry_.add<Health>();
        registry_.add<Position>();
        registry_.add<Byte>();
        registry_.add<Frozen>();
        registry_.add<Hidden>();
        registry_.add<Parent>();
        registry_.add<Light>();
        registry_.add<Burning>();
        registry_.add<Selected>();
        registry_.add_transient<Anchored>("anchored");
        registry_.add_transient<Owner>("owner");
        registry_.add_transient<Line>("line");
        registry_.add_transient<SparseAnchored>("sparse anchored");
    }

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
        reset.operator()<SparseAnchored>();
    }

    TypeRegistry registry_;
    SnapshotWriter writer_{registry_};
    std::optional<RestoredWorld> restored_;
    Queries queries_;
};

}  // namespace rambla::ecs::property
