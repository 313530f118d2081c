#include "game/collision.h"

#include <algorithm>
#include <cmath>

namespace rambla::game {
namespace {

/// Corners come in pairs of walls; a third round catches what the second pushed into, a fourth settles it.
constexpr int k_rounds = 4;

/// A triangle cut by two horizontal planes: up to five corners.
struct Polygon {
    std::array<glm::vec3, 6> corners;
    std::size_t count = 0;
    void add(glm::vec3 corner) { corners[count++] = corner; }
};

/// Keeps the part of a convex polygon where sign · (y − height) ≥ 0 (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, float height, float sign) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::vec3 from = polygon.corners[i];
        const glm::vec3 to = polygon.corners[(i + 1) % polygon.count];
        const float from_inside = sign * (from.y - height);
        const float to_inside = sign * (to.y - height);
        if (from_inside >= 0.0f) kept.add(from);
        if ((from_inside >= 0.0f) != (to_inside >= 0.0f)) {
            kept.add(glm::mix(from, to, from_inside / (from_inside - to_inside)));
        }
    }
    return kept;
}

glm::vec2 plan(glm::vec3 point) {
    return {point.x, point.z};
}

glm::vec2 nearest_on_edge(glm::vec2 from, glm::vec2 to, glm::vec2 point) {
    const glm::vec2 edge = to - from;
    const float length2 = glm::dot(edge, edge);
    const float share =
        length2 > 0.0f ? std::clamp(glm::dot(point - from, edge) / length2, 0.0f, 1.0f) : 0.0f;
    return from + share * edge;
}

/// How far, and which way, one triangle pushes a circle out of itself; zero if they do not touch.
glm::vec2 push_of(const Triangle& triangle, glm::vec3 feet_m, const Walker& walker) {
    const float bottom = feet_m.y + walker.step_m;
    const float top = feet_m.y + walker.height_m;
    const auto [lowest, highest] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    if (highest < bottom || lowest > top) return glm::vec2{0.0f};

    Polygon polygon;
    for (const glm::vec3& corner : triangle)
        polygon.add(corner);
    polygon = clipped(clipped(polygon, bottom, 1.0f), top, -1.0f);
    const glm::vec2 centre = plan(feet_m);
    float nearest2 = walker.radius_m * walker.radius_m;
    glm::vec2 away{0.0f};
    bool touches = false;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::vec2 point =
            nearest_on_edge(plan(polygon.corners[i]), plan(polygon.corners[(i + 1) % polygon.count]), centre);
        const glm::vec2 offset = centre - point;
        if (glm::dot(offset, offset) >= nearest2) continue;
        nearest2 = glm::dot(offset, offset);
        away = offset;
        touches = true;
    }
    if (!touches) return glm::vec2{0.0f};
    const float distance = std::sqrt(nearest2);
    if (distance > 1e-5f) return away / distance * (walker.radius_m - distance);
    // The centre stands on the wall itself: out along the wall's own normal.
    const glm::vec2 normal = plan(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
    const float length = glm::length(normal);
    return length > 0.0f ? normal / length * walker.radius_m : glm::vec2{0.0f};
}

/// Height of a triangle at a point of the plan; nothing if the point lies outside it, or it is too steep to
/// stand on.
std::optional<float> floor_height(const Triangle& triangle, glm::vec2 point) {
    const glm::vec2 a = plan(triangle[0]);
    const glm::vec2 ab = plan(triangle[1]) - a;
    const glm::vec2 ac = plan(triangle[2]) - a;
    const float area = ab.x * ac.y - ab.y * ac.x;
    if (area == 0.0f) return std::nullopt;
    const glm::vec2 ap = point - a;
    const float v = (ap.x * ac.y - ap.y * ac.x) / area;
    const float w = (ab.x * ap.y - ab.y * ap.x) / area;
    // Seams between neighbours must not let the foot through.
    constexpr float k_seam = 1e-4f;
    if (v < -k_seam || w < -k_seam || v + w > 1.0f + k_seam) return std::nullopt;
    const glm::vec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    if (std::abs(normal.y) < k_walkable_cosine * glm::length(normal)) return std::nullopt;
    return triangle[0].y + v * (triangle[1].y - triangle[0].y) + w * (triangle[2].y - triangle[0].y);
}

}  // namespace

std::optional<float> ground_height(std::span<const Triangle> triangles, glm::vec3 feet_m,
                                   const Walker& walker) {
    std::optional<float> highest;
    for (const Triangle& triangle : triangles) {
        const std::optional<float> height = floor_height(triangle, plan(feet_m));
        if (!height || *height > feet_m.y + walker.step_m) continue;
        highest = std::max(highest.value_or(*height), *height);
    }
    return highest;
}

glm::vec3 pushed_out(std::span<const Triangle> triangles, glm::vec3 feet_m, const Walker& walker) {
    for (int round = 0; round < k_rounds; ++round) {
        glm::vec2 deepest{0.0f};
        for (const Triangle& triangle : triangles) {
            const glm::vec2 push = push_of(triangle, feet_m, walker);
            if (glm::dot(push, push) > glm::dot(deepest, deepest)) deepest = push;
        }
        if (deepest == glm::vec2{0.0f}) break;
        feet_m += glm::vec3{deepest.x, 0.0f, deepest.y};
    }
    return feet_m;
}

}  // namespace rambla::game
