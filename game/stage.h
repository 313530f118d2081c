#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "assets/daylight.h"
#include "assets/place.h"
#include "ecs/world.h"
#include "systems/pipeline.h"

namespace rambla::game {

/// A world with a place in it, and what a visitor of that place needs.
struct Stage {
    std::unique_ptr<ecs::World> world;
    std::shared_ptr<const assets::Scene> scene;
    std::vector<assets::CameraKey> walk;
    float walk_fov_rad = 1.0f;
    float walk_near_m = 0.05f;
    float exposure_ev = 0.0f;        ///< that its light wants
    std::vector<ecs::Entity> nodes;  ///< of the scene's nodes; null for those that were not spawned
    ecs::Entity player;              ///< plays the scene's clips; null if it has none
    systems::WorldPosition origin;   ///< where the place's own (0,0,0) stands
};

/// Generates a scene by its name, such as `city:blocks=2x2`, in the light of a time, and spawns it. @throws
/// std::invalid_argument
[[nodiscard]] Stage make_stage(const std::string& scene, std::uint64_t seed, assets::TimeOfDay time,
                               const systems::WorldPosition& origin);

/// Spawns a place.
[[nodiscard]] Stage make_stage(assets::Place place, std::uint64_t seed, const systems::WorldPosition& origin);

/// Spawns what a file holds, under the given light; glass is shown by blending.
[[nodiscard]] Stage make_stage(assets::Scene scene, const assets::Environment& light,
                               const systems::WorldPosition& origin);

/// Eye of the standard walk at a time; the walk must have keys.
[[nodiscard]] systems::Eye walk_eye(const Stage& stage, float time_s);

}  // namespace rambla::game
