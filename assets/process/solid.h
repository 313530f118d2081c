#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "assets/process/surface.h"

namespace rambla::assets {

/// Whether every edge, between places, is passed as often in one direction as in the other: then the surface
/// has no border and each point off it has a whole winding number.
[[nodiscard]] bool is_closed(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// How often a closed surface winds around a point: 0 outside, 1 inside of one that faces outwards. Jacobson
/// et al. 2013, "Robust inside-outside segmentation using generalized winding numbers", eq. 5; solid angles
/// by Van Oosterom & Strackee 1983.
[[nodiscard]] double winding_number(const Surface& surface, glm::dvec3 point);

/// Volume that a closed surface encloses, m³; negative where it faces inwards.
[[nodiscard]] double enclosed_volume(const Surface& surface);

/// Whether a triangle and a closed box touch. Akenine-Möller 2001, "Fast 3D triangle-box overlap testing";
/// counts what is nearer than rounding could tell as touching.
[[nodiscard]] bool touches_box(const TriangleCorners& triangle, glm::dvec3 box_min, glm::dvec3 box_max);

}  // namespace rambla::assets
