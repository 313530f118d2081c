#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assets/scene.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/spawn.h"

namespace rambla::systems {

/// The entity made from a node.
struct SpawnedNode {
    std::uint32_t node = 0;
    ecs::Entity entity;
};

struct SpawnedSubtrees {
    std::vector<SpawnedNode> nodes;  ///< parents before children
    /// What the roots hang from where clips move any node or a skeleton any mesh, so that an actor can be
    /// moved whatever its clips do with its root. Has the AnimationPlayer of them all if there are clips.
    /// Else null.
    ecs::Entity stand;

    /// What the whole is moved by.
    [[nodiscard]] ecs::Entity root() const { return stand != ecs::Entity{} ? stand : nodes[0].entity; }
};

/// Makes entities for the subtrees of `roots`.
/// @param near_fade  of every mesh there, if any
/// @throws std::out_of_range  for indices that the scene does not have
SpawnedSubtrees spawn_subtrees(ecs::World& world, const assets::Scene& scene,
                               std::span<const std::uint32_t> roots, const WorldPosition& origin,
                               Mobility mobility, const std::optional<NearFade>& near_fade = {});

/// Makes the scene's clips, skeletons and deformable meshes known to the systems that play them.
void note_clips(ecs::World& world, const assets::Scene& scene);

/// Makes the scene's materials known to the queues.
void note_materials(ecs::World& world, const assets::Scene& scene);

}  // namespace rambla::systems
