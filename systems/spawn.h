#pragma once

#include <cstdint>
#include <vector>

#include "assets/place.h"
#include "assets/scene.h"
#include "ecs/world.h"
#include "systems/components.h"

namespace rambla::systems {

/// Entities made from one scene, by node index; nodes that were not spawned hold the null entity.
struct SpawnedScene {
    std::vector<ecs::Entity> nodes;
    ecs::Entity player;  ///< whose AnimationPlayer moves them; null if no clip does
};

/// Whether entities take part in every step, or stay where they were spawned.
enum class Mobility : std::uint8_t { fixed, moving };

/// Beyond this, a local light without a range of its own ends: where its illuminance falls below the
/// threshold (π lights a white surface to radiance 1, so this one adds less than a third of a display's 8-bit
/// step), at most a hundred metres away.
inline constexpr float k_light_threshold = 0.004f;
inline constexpr float k_light_reach_m = 100.0f;

/// Makes entities for all nodes under the scene's roots, placed at `origin`: the hierarchy, what it shows,
/// its lights. A model of several parts becomes one child entity per part. Nothing of it moves but what the
/// scene's clips animate, with all that hangs from it, once the player is given a clip. Blended
/// materials, lines and points throw no shadow. Mesh and material indices stay those of the scene, so one
/// scene (see assets::append) serves a world. The first directional light becomes the sun of the Sunlight
/// resource (noon, where there was none); others are warned about.
SpawnedScene spawn(ecs::World& world, const assets::Scene& scene, const WorldPosition& origin);

/// Makes one more copy of a prototype's subtree and returns its root, which is placed at `origin` by its own
/// transform; if clips or skeletons belong to it, what it hangs from, which stands at `origin` and holds its
/// AnimationPlayer. What is skinned is seen after the next step or settle_deformations().
ecs::Entity spawn_prototype(ecs::World& world, const assets::Scene& scene, std::uint32_t node,
                            const WorldPosition& origin, Mobility mobility = Mobility::fixed);

/// Spawns a generated place: its scene, its light as the Sunlight resource, its paths, actors and movers.
/// Parts of walkers are known by their nodes' names: leg_l, leg_r, shin_l, shin_r, arm_l, arm_r, forearm_l,
/// forearm_r, torso, head; wheels of cars begin with wheel_. Models face −Z and stand on y = 0.
/// @param seed  of all that its actors will choose
SpawnedScene spawn(ecs::World& world, const assets::Place& place, const WorldPosition& origin,
                   std::uint64_t seed);

}  // namespace rambla::systems
