#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "assets/image.h"

namespace rambla::game::study {

/// A part of a picture, cut to what lies inside of it.
/// @param corner_px  its upper left one
[[nodiscard]] assets::Image part_of(const assets::Image& image, glm::uvec2 corner_px, glm::uvec2 size_px);

/// Upper left corner of the part of this size in which two pictures differ most, among parts that begin at
/// every eighth of its size; the first of equal ones.
/// @param a, b  rgba8, of one size
[[nodiscard]] glm::uvec2 most_different_part(const assets::Image& a, const assets::Image& b,
                                             glm::uvec2 size_px);

/// Each pixel as a square of `times` × `times`.
[[nodiscard]] assets::Image enlarged(const assets::Image& image, std::uint32_t times);

}  // namespace rambla::game::study
