#include "assets/generate/form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assets/assert.h"

namespace rambla::assets::generate {

namespace {

/// Directions to the corners that are left of a convex polygon.
struct Corners {
    std::array<glm::dvec3, k_most_corners + 1> at{};
    std::size_t count = 0;

    void add(glm::dvec3 corner) { at[count++] = corner; }
};

/// A convex polygon crosses a plane twice at most, so that one corner more is the most. Sutherland and
/// Hodgman 1974.
Corners above_horizon(std::span<const glm::dvec3> corners, glm::dvec3 point, glm::dvec3 normal) {
    Corners above;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i] - point;
        const glm::dvec3 b = corners[(i + 1) % corners.size()] - point;
        const double height_a = glm::dot(a, normal);
        const double height_b = glm::dot(b, normal);
        if (height_a >= 0.0) above.add(a);
        if ((height_a > 0.0 && height_b < 0.0) || (height_a < 0.0 && height_b > 0.0))
            above.add(a + (b - a) * (height_a / (height_a - height_b)));
    }
    return above;
}

}  // namespace

double form_factor(std::span<const glm::dvec3> corners, glm::dvec3 point, glm::dvec3 normal) {
    RAMBLA_ASSERT(corners.size() >= 3 && corners.size() <= k_most_corners,
                  "callers have polygons of a few corners");
    const Corners above = above_horizon(corners, point, normal);
    double sum = 0.0;
    for (std::size_t i = 0; i < above.count; ++i) {
        const glm::dvec3 a = above.at[i];
        const glm::dvec3 b = above.at[(i + 1) % above.count];
        const glm::dvec3 cross = glm::cross(a, b);
        const double length = glm::length(cross);
        // An edge in line with the point spans no angle, and one through it none of which the side is known.
        if (length == 0.0) continue;
        sum += std::atan2(length, glm::dot(a, b)) * glm::dot(cross, normal) / length;
    }
    return std::clamp(-sum / (2.0 * std::numbers::pi), 0.0, 1.0);
}

}  // namespace rambla::assets::generate
