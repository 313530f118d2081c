#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>

#include "assets/place.h"
#include "assets/scene.h"

namespace rambla::test {

/// One material, one unit cube about the origin, one model of them; no nodes yet.
[[nodiscard]] assets::Scene box_scene();

/// Adds a node, as a root if it has no parent.
std::uint32_t add_node(assets::Scene& scene, std::uint32_t parent, const assets::Transform& local);

/// Four boxes, a lamp and a pane of glass on a crossroads of pavements and a ring of lanes, with walkers and
/// cars made of boxes.
[[nodiscard]] assets::Place small_place(int walkers, int cars);

}  // namespace rambla::test
