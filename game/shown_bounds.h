#pragma once

#include "assets/bounds.h"
#include "assets/scene.h"
#include "ecs/world.h"
#include "systems/components.h"

namespace rambla::game {

/// Box around all that a world shows, seen from `origin`; empty if it shows nothing. Of what is skinned or
/// morphed every vertex is looked at: bounds for culling are far wider, and a picture framed by them mostly
/// shows air.
/// @param scene  whose indices the world uses
[[nodiscard]] assets::Bounds shown_bounds(const ecs::World& world, const assets::Scene& scene,
                                          const systems::WorldPosition& origin);

}  // namespace rambla::game
