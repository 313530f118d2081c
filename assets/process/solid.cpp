#include "assets/process/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assets/process/columns.h"

namespace rambla::assets {

bool is_closed(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    const std::vector<std::uint32_t> place = welded_by_position(positions);
    struct Edge {
        std::uint32_t low, high;
        int direction;
    };
    std::vector<Edge> edges;
    edges.reserve(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::uint32_t from = place[indices[i]];
        const std::uint32_t to = place[indices[i % 3 == 2 ? i - 2 : i + 1]];
        if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
    const auto same = [](const Edge& a, const Edge& b) {
        return a.low == b.low && a.high == b.high;
    };
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    for (std::size_t i = 0; i < edges.size();) {
        int sum = 0;
        const std::size_t first = i;
        for (; i < edges.size() && same(edges[i], edges[first]); ++i)
            sum += edges[i].direction;
        if (sum != 0) return false;
    }
    return !edges.empty();
}

double winding_number(const Surface& surface, glm::dvec3 point) {
    double half_angles = 0.0;
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        const TriangleCorners t = surface.corners(triangle);
        const glm::dvec3 a = t[0] - point;
        const glm::dvec3 b = t[1] - point;
        const glm::dvec3 c = t[2] - point;
        const double la = glm::length(a);
        const double lb = glm::length(b);
        const double lc = glm::length(c);
        half_angles +=
            std::atan2(glm::dot(a, glm::cross(b, c)),
                       la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return half_angles / (2.0 * std::numbers::pi);
}

double enclosed_volume(const Surface& surface) {
    if (surface.triangle_count() == 0) return 0.0;
    // About a point of the surface: about a far origin, large terms of both signs would cancel.
    const glm::dvec3 origin = surface.corners(0)[0];
    double six_volumes = 0.0;
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        const TriangleCorners t = surface.corners(triangle);
        six_volumes += glm::dot(t[0] - origin, glm::cross(t[1] - origin, t[2] - origin));
    }
    return six_volumes / 6.0;
}

bool touches_box(const TriangleCorners& triangle, glm::dvec3 box_min, glm::dvec3 box_max) {
    const glm::dvec3 centre = 0.5 * (box_min + box_max);
    const TriangleCorners t{triangle[0] - centre, triangle[1] - centre, triangle[2] - centre};
    const glm::dvec3 half = 0.5 * (box_max - box_min);
    constexpr double k_rounding = 1e-12;
    double size = std::max({half.x, half.y, half.z, glm::length(centre)});
    for (const glm::dvec3& corner : t)
        size = std::max(size, glm::length(corner));

    const auto apart_along = [&](glm::dvec3 axis) {
        const double p0 = glm::dot(t[0], axis);
        const double p1 = glm::dot(t[1], axis);
        const double p2 = glm::dot(t[2], axis);
        const double reach = glm::dot(half, glm::abs(axis)) + k_rounding * size * glm::length(axis);
        return std::min({p0, p1, p2}) > reach || std::max({p0, p1, p2}) < -reach;
    };
    const std::array<glm::dvec3, 3> axes{glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}};
    for (const glm::dvec3& axis : axes)
        if (apart_along(axis)) return false;
    const std::array<glm::dvec3, 3> edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    if (apart_along(glm::cross(edges[0], edges[1]))) return false;
    for (const glm::dvec3& edge : edges)
        for (const glm::dvec3& axis : axes)
            if (apart_along(glm::cross(axis, edge))) return false;
    return true;
}

}  // namespace rambla::assets
