#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>

#include "assets/bounds.h"

namespace rambla::render::shadow {

/// Corners of the intersection of a hexahedron and a box: every corner of it is a corner of a face of one
/// body clipped to the other, hence two times six quads, each clipped by six planes.
struct ConvexPoints {
    std::array<glm::vec3, 12 * 10> points{};
    std::size_t count = 0;

    [[nodiscard]] std::span<const glm::vec3> span() const { return {points.data(), count}; }
};

/// @param hexahedron  corners in the order of frustum_slice(); convex
/// @return  no points where the two do not meet
[[nodiscard]] ConvexPoints intersect(const std::array<glm::vec3, 8>& hexahedron, const assets::Bounds& box);

}  // namespace rambla::render::shadow
