#pragma once

#include "assets/scene.h"

namespace rambla::assets::test {

/// One of everything that a scene without motion can hold: materials, lights and cameras of each kind.
[[nodiscard]] Scene standing_scene();

/// One of everything that moves, and levels of detail: node 0 shows model 0, two skinned, morphing triangles
/// that skeleton 0 moves; node 3 shows model 1 with a coarser level, node 4.
[[nodiscard]] Scene moving_scene();

}  // namespace rambla::assets::test
