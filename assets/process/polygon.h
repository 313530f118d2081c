#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <utility>

#include "assets/process/surface.h"

namespace rambla::assets {

/// A plane through `origin`; what lies along `normal` is above it.
struct Plane {
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit length
    glm::dvec3 origin{0.0};
};

[[nodiscard]] inline double height(const Plane& plane, glm::dvec3 point) {
    return glm::dot(plane.normal, point - plane.origin);
}

/// A flat convex polygon of few corners.
class Polygon {
public:
    static constexpr std::size_t k_most_points = 12;

    [[nodiscard]] std::span<const glm::dvec3> points() const { return std::span{points_}.first(count_); }
    [[nodiscard]] glm::dvec3 middle() const;
    void add(glm::dvec3 point);

private:
    std::array<glm::dvec3, k_most_points> points_{};
    std::size_t count_ = 0;
};

[[nodiscard]] Polygon polygon_of(const TriangleCorners& triangle);

/// What lies above a plane, and what lies below; either may have no points. Together they have at most four
/// points more. Sutherland & Hodgman 1974, for both sides at once.
[[nodiscard]] std::pair<Polygon, Polygon> cut(const Polygon& polygon, const Plane& plane);

/// Halves the polygon across its longest extent from corner to corner.
[[nodiscard]] Plane middle_plane(const Polygon& polygon);

}  // namespace rambla::assets
