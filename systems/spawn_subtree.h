#pragma once

#include <cstdint>
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

/// Makes entities for the subtrees of `roots`, parents before children. Throws std::out_of_range for indices
/// that the scene does not have.
std::vector<SpawnedNode> spawn_subtrees(ecs::World& world, const assets::Scene& scene,
                                        std::span<const std::uint32_t> roots, const WorldPosition& origin,
                                        Mobility mobility);

/// Makes the scene's materials known to the queues.
void note_materials(ecs::World& world, const assets::Scene& scene);

}  // namespace rambla::systems
