#pragma once

#include <cstdint>
#include <string_view>

#include "game/stage.h"

namespace rambla::game::study {

/// Where the camera of a measured picture stands.
enum class View : std::uint8_t {
    above,  ///< comparison camera: roofs and ground, little hidden
    below   ///< at a walker's eye along the rows: many walls, one behind the other
};

[[nodiscard]] std::string_view to_text(View view);

/// The comparison scene `blocks` with other lights: `lights` point lights of radius 20 m in a square grid
/// over the same ground, each 300 cd at a height of 14 m, and `suns` − 1 further directional lights.
/// @param suns  at least 1
[[nodiscard]] Stage blocks_with_lights(std::uint32_t lights, std::uint32_t suns);

/// @param share  of the camera's way, [0, 1): which of a view's pictures
[[nodiscard]] systems::Eye eye_of(const Stage& stage, View view, double share, glm::uvec2 size_px);

}  // namespace rambla::game::study
