#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace rambla::assets {

/// Axis-aligned box in metres. The default box is empty: min > max, and expanding it by a point gives that
/// point.
struct Bounds {
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};

    [[nodiscard]] bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    [[nodiscard]] glm::vec3 centre() const { return 0.5f * min + 0.5f * max; }
    [[nodiscard]] glm::vec3 half_extents() const { return 0.5f * max - 0.5f * min; }

    void expand(glm::vec3 point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void expand(const Bounds& other) {
        if (other.empty()) return;
        expand(other.min);
        expand(other.max);
    }
};

/// The box of a box under an affine map; encloses the exact image. Empty boxes stay empty.
/// Arvo 1990, "Transforming axis-aligned bounding boxes".
[[nodiscard]] inline Bounds transformed(const Bounds& box, const glm::mat4& to_from) {
    if (box.empty()) return box;
    const glm::mat3 linear{to_from};
    const glm::mat3 magnitude{glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2])};
    const glm::vec3 centre = glm::vec3{to_from * glm::vec4{box.centre(), 1.0f}};
    const glm::vec3 half = magnitude * box.half_extents();
    return {centre - half, centre + half};
}

}  // namespace rambla::assets
