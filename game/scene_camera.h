#pragma once

#include <cstdint>
#include <optional>

#include "assets/scene.h"
#include "game/stage.h"

namespace rambla::game {

/// The node of the `index`-th camera that the scene shows by default; nothing if it has fewer.
[[nodiscard]] std::optional<std::uint32_t> find_camera(const assets::Scene& scene, std::uint32_t index);

/// Eye of a node's camera, where the world has that node now.
/// @param node           one that find_camera() has found in the stage's scene
/// @param interpolation  between the step before (0) and the newest (1)
[[nodiscard]] systems::Eye camera_eye(const Stage& stage, std::uint32_t node, float interpolation);

}  // namespace rambla::game
