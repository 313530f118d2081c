#pragma once

#include <cstdint>

#include "ecs/res.h"
#include "ecs/view.h"
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

/// System: moves followers along their paths by one step, and their gaits as far as they went.
void follow_paths(ecs::View<ecs::Entity, PathFollower, LocalTransform, Cell, ecs::Optional<Gait>> followers,
                  ecs::Res<Paths> paths);

/// System: turns the limbs of walkers as their gaits say.
void swing_limbs(ecs::View<const GaitLimb, LocalTransform> limbs, ecs::Lookup<const Gait> gaits);

/// System: turns wheels as far as their cars went.
void roll_wheels(ecs::View<const WheelSpin, LocalTransform> wheels, ecs::Lookup<const PathFollower> cars);

}  // namespace rambla::systems
