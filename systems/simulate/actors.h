#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/simulate/paths.h"

namespace rambla::systems {

/// Distance from the corners at which this kind of actor turns at least: the radius of its tightest usual
/// turn.
[[nodiscard]] float least_turn_m(assets::ActorKind kind);

/// A follower at a place of its network, as ActorStart gives it (`first_link`: where the network begins in
/// the graph).
[[nodiscard]] PathFollower starting(const PathGraph& graph, std::uint32_t first_link,
                                    const assets::ActorStart& start);

/// Where a follower is; normalised.
[[nodiscard]] WorldPosition place_of(const PathGraph& graph, const PathFollower& follower);

/// The follower after one step of `step_s`. Walkers keep right, on a line of their own on each link; the next
/// link at each point is drawn by (seed, who, number of the turn).
/// @param who  same number for the same actor in every run
[[nodiscard]] PathFollower advanced(const PathGraph& graph, const PathFollower& follower, std::uint64_t seed,
                                    std::uint64_t who, float step_s);

/// Moves all actors by one step: followers along the Paths resource, then limbs and wheels as far as their
/// actors went.
class ActorMotion {
public:
    /// Allocates nothing in a steady state.
    void operator()(ecs::World& world);

private:
    using Followers = ecs::Query<ecs::Entity, PathFollower, LocalTransform, Cell, ecs::Optional<Gait>>;
    using Limbs = ecs::Query<const GaitLimb, LocalTransform>;
    using Wheels = ecs::Query<const WheelSpin, LocalTransform>;

    struct FollowerChunk {
        std::span<const ecs::Entity> entities;
        std::span<PathFollower> followers;
        std::span<LocalTransform> local;
        std::span<Cell> cells;
        std::span<Gait> gaits;  ///< empty: wheels, not legs
    };
    template <class Part>
    struct PartChunk {
        std::span<const Part> parts;
        std::span<LocalTransform> local;
    };

    Followers followers_;
    Limbs limbs_;
    Wheels wheels_;
    std::vector<FollowerChunk> follower_chunks_;
    std::vector<PartChunk<GaitLimb>> limb_chunks_;
    std::vector<PartChunk<WheelSpin>> wheel_chunks_;
};

}  // namespace rambla::systems
