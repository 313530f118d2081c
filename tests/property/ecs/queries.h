#pragma once

#include <cstddef>
#include <tuple>

#include "property/ecs/query_check.h"

namespace rambla::ecs::property {

/// The queries that random worlds are checked with: every kind of term, alone and together.
class Queries {
public:
    void check_all(const World& world, Model& model) {
        std::apply([&](auto&... query) { (query.check(world, model), ...); }, queries_);
    }
    /// One of them.
    void check(std::size_t number, const World& world, Model& model) {
        std::size_t next = 0;
        const std::size_t chosen = number % std::tuple_size_v<decltype(queries_)>;
        const auto one = [&](auto& query) {
            if (next++ == chosen) query.check(world, model);
        };
        std::apply([&](auto&... query) { (one(query), ...); }, queries_);
    }

private:
    std::tuple<
        CheckedQuery<Entity>,
        CheckedQuery<Entity, Optional<const Health>, Optional<const Position>, Optional<const Anchored>,
                     Optional<const Owner>, Optional<const Line>, Optional<const Byte>,
                     Optional<const Parent>, Optional<const Ticket>, Optional<const Score>,
                     Optional<const Quad>>,
        CheckedQuery<Entity, const Health, const Anchored>, CheckedQuery<Entity, const Position>,
        CheckedQuery<Entity, With<Frozen>, Without<Health>>,
        CheckedQuery<Entity, With<Frozen>, With<Hidden>, Optional<const Byte>>,
        CheckedQuery<Entity, Without<Frozen>, const Owner, Without<Hidden>>,
        CheckedQuery<Entity, const Line, Without<Parent>>,
        CheckedQuery<Entity, const Parent, With<Byte>, Optional<const Anchored>>,
        CheckedQuery<Entity, Optional<const Light>, Optional<const Burning>, Optional<const SparseAnchored>>,
        CheckedQuery<Entity, const Burning, const Health>, CheckedQuery<Entity, const SparseAnchored>,
        CheckedQuery<Entity, With<Selected>, Without<Burning>>,
        CheckedQuery<Entity, Without<Selected>, const Position, With<SparseAnchored>>,
        CheckedQuery<Entity, AnyOf<Health, Frozen, Line>>,
        CheckedQuery<Entity, AnyOf<Selected, Byte>, Without<Anchored>>,
        CheckedQuery<Entity, AnyOf<Burning, Selected>, Optional<const Burning>>,
        CheckedQuery<Entity, const Light, Enabled<Light>>, CheckedQuery<Entity, Shared<Material>>,
        CheckedQuery<Entity, const Health, Shared<Material>, Without<Selected>>,
        CheckedQuery<Entity, Without<Material>>, CheckedQuery<Entity, Shared<Tint>, Optional<const Score>>,
        CheckedQuery<Entity, Shared<Material>, Shared<Tint>>,
        CheckedQuery<Entity, const Ticket, Without<Score>>,
        CheckedQuery<Entity, const Quad, AnyOf<Tint, Score>>,
        CheckedQuery<Entity, With<Material>, Optional<const Anchored>>,
        CheckedQuery<Entity, Disabled<Light>, Optional<const Light>>,
        CheckedQuery<Entity, Enabled<Light>, With<Burning>, Without<Frozen>>>
        queries_;
};

}  // namespace rambla::ecs::property
