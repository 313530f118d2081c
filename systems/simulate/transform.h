#pragma once

#include "ecs/propagation.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "systems/components.h"

namespace rambla::systems {

/// The same rotation as a unit quaternion. Near unit length one Newton step for 1/√n keeps it there, however
/// many products it has gone through; anything else is scaled down first, and what has no direction is no
/// rotation.
[[nodiscard]] glm::quat renormalised(const glm::quat& rotation);

/// Where a root is: its transform counts from the corner of its cell.
[[nodiscard]] WorldTransform root_transform(const Cell& cell, const LocalTransform& local);

/// Where a child is, in its parent's cell. Exact matrices, so that non-uniform parents shear their children.
[[nodiscard]] WorldTransform child_transform(const WorldTransform& parent, const LocalTransform& local);

/// Carries LocalTransforms down the hierarchy to WorldTransforms, for the things that move: those with a
/// PreviousWorldTransform, which gets the transform of the step before. Everything below a moving entity must
/// be moving too (spawn sees to it). Things without one are neither read nor written, except as parents.
///
/// Roots that left their cell are counted from the new one; rotations are renormalised, step by step until
/// they stay. Entities whose parent has died stay where they are. Visits what was written and what hangs from
/// it; the state is the same as if it visited all.
class TransformPropagation {
public:
    /// One step. Allocates nothing unless moving entities, or their parents, were changed since the last.
    void operator()(ecs::World& world);

private:
    ecs::Query<const WorldTransform, PreviousWorldTransform, ecs::Changed<WorldTransform>> moved_;
    ecs::Since copied_;  ///< WorldTransforms up to here are in PreviousWorldTransform
    ecs::Propagation<LocalTransform, WorldTransform, ecs::With<PreviousWorldTransform>, ecs::Optional<Cell>>
        propagate_;
};

/// Brings all that moves to where its LocalTransform says, as if it had been there before: after spawning or
/// a leap.
void settle(ecs::World& world);

}  // namespace rambla::systems
