#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "game/study/metrics/flip_kernels.h"
#include "game/study/picture.h"

namespace rambla::game::study::flip {

/// What the eye makes of a pixel.
struct Seen {
    glm::vec3 hunt_lab;  ///< of the blurred picture
    float edge;          ///< strength of an edge here, 0 to about 1; of the luminance before the blur
    float point;         ///< strength of a point or thin line
};

/// @param picture  linear light in [0, 1], finite
/// @return         per pixel, row-major
/// Andersson et al. 2020, on spatial filtering and feature detection. Rows are filtered side by side.
[[nodiscard]] std::vector<Seen> see(const Picture& picture, const Kernels& kernels);

/// Colour difference raised to 1 − feature difference, 0 to 1; symmetric.
[[nodiscard]] float difference(const Seen& a, const Seen& b);

}  // namespace rambla::game::study::flip
