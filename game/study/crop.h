#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "assets/image.h"

namespace rambla::game::study {

/// A rectangle of a picture, in pixels from its upper left corner.
struct Crop {
    glm::uvec2 corner_px{0};
    glm::uvec2 size_px{0};
};

/// The crop of that size, or of the picture's where that is smaller, in which the sum of a map is largest.
/// The first of equal ones, top row first.
/// @param map  a weight per pixel, row-major, ≥ 0
[[nodiscard]] Crop heaviest_crop(glm::uvec2 picture_px, std::span<const float> map, glm::uvec2 size_px);

/// The crop's pixels, each as a square of `times` × `times`.
/// @param image  rgba8, which the crop lies in
[[nodiscard]] assets::Image enlarged(const assets::Image& image, const Crop& crop, std::uint32_t times);

}  // namespace rambla::game::study
