#pragma once

#include <cstdint>
#include <span>
#include <vector>

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
/// Roots that left their cell are counted from the new one; rotations are renormalised. Entities whose parent
/// has died stay where they are.
class TransformPropagation {
public:
    /// One step. Allocates nothing unless moving entities, or their parents, were changed since the last.
    void operator()(ecs::World& world);

private:
    using Moving = ecs::Query<ecs::Entity, LocalTransform, WorldTransform, PreviousWorldTransform,
                              ecs::Optional<const Parent>, ecs::Optional<Cell>>;

    struct Chunk {
        std::span<const ecs::Entity> entities;
        std::span<LocalTransform> local;
        std::span<WorldTransform> world;
        std::span<PreviousWorldTransform> previous;
        std::span<const Parent> parents;  ///< empty: roots
        std::span<Cell> cells;            ///< empty: roots of cell 0, or children
    };
    /// A row of the query: which chunk, and where in it.
    struct Row {
        std::uint32_t chunk = 0;
        std::uint32_t place = 0;
    };
    struct Member {
        ecs::Entity entity;
        ecs::Entity parent;  ///< null for roots

        bool operator==(const Member&) const = default;
    };
    struct Link {
        Row row;
        Row parent;  ///< where `fixed_parent` is null
        ecs::Entity fixed_parent;
    };

    void gather(ecs::World& world);
    [[nodiscard]] bool order_is_current() const;
    void rebuild_order(const ecs::World& world);
    void move_root(Row row) const;
    void move_child(const ecs::World& world, const Link& link) const;

    Moving moving_;
    std::vector<Chunk> chunks_;
    std::vector<Member> members_;  ///< of all rows in the query's order, when the order was made
    std::vector<Row> roots_;
    std::vector<Link> children_;           ///< parents before children
    std::vector<std::size_t> level_ends_;  ///< ends in children_ of depth 1, 2, …
};

/// Brings all that moves to where its LocalTransform says, as if it had been there before: after spawning or
/// a leap.
void settle(ecs::World& world);

}  // namespace rambla::systems
