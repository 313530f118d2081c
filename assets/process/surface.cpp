#include "assets/process/surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rambla::assets {

namespace {

constexpr std::uint32_t k_leaf_triangles = 4;

PointOnTriangle measured(glm::dvec3 point, const TriangleCorners& t, glm::dvec3 weights) {
    const glm::dvec3 nearest = weights.x * t[0] + weights.y * t[1] + weights.z * t[2];
    return {weights, glm::distance(point, nearest)};
}

/// Share of the way from a to b at which the segment is nearest to a point.
double share_along(glm::dvec3 point, glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 along = b - a;
    const double length_squared = glm::dot(along, along);
    return length_squared > 0.0 ? std::clamp(glm::dot(point - a, along) / length_squared, 0.0, 1.0) : 0.0;
}

PointOnTriangle nearest_on_edges(glm::dvec3 point, const TriangleCorners& t) {
    PointOnTriangle best;
    for (int edge = 0; edge < 3; ++edge) {
        const int next = (edge + 1) % 3;
        const double share =
            share_along(point, t[static_cast<std::size_t>(edge)], t[static_cast<std::size_t>(next)]);
        glm::dvec3 weights{0.0};
        weights[edge] = 1.0 - share;
        weights[next] = share;
        const PointOnTriangle candidate = measured(point, t, weights);
        if (candidate.distance < best.distance) best = candidate;
    }
    return best;
}

double distance_squared(glm::dvec3 point, glm::dvec3 min, glm::dvec3 max) {
    const glm::dvec3 outside = glm::max(glm::max(min - point, point - max), glm::dvec3{0.0});
    return glm::dot(outside, outside);
}

}  // namespace

PointOnTriangle nearest_on_triangle(glm::dvec3 point, const TriangleCorners& t) {
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double area_squared = glm::dot(normal, normal);
    // Where the plane is not known the answer lies on an edge, and so it does where a weight is negative.
    if (!(area_squared > 0.0)) return nearest_on_edges(point, t);
    const double a = glm::dot(glm::cross(t[1] - point, t[2] - point), normal) / area_squared;
    const double b = glm::dot(glm::cross(t[2] - point, t[0] - point), normal) / area_squared;
    const double c = 1.0 - a - b;
    if (!(a >= 0.0 && b >= 0.0 && c >= 0.0)) return nearest_on_edges(point, t);
    return measured(point, t, {a, b, c});
}

Surface::Surface(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices)
    : positions_{positions}, indices_{indices}, order_(indices.size() / 3) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(2 * order_.size() / k_leaf_triangles + 1);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

TriangleCorners Surface::corners(std::uint32_t triangle) const {
    const std::uint32_t* const i = &indices_[std::size_t{3} * triangle];
    return {glm::dvec3{positions_[i[0]]}, glm::dvec3{positions_[i[1]]}, glm::dvec3{positions_[i[2]]}};
}

void Surface::build(std::uint32_t first, std::uint32_t count) {
    const std::size_t here = nodes_.size();
    nodes_.emplace_back();
    const std::span<std::uint32_t> triangles = std::span{order_}.subspan(first, count);
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};
    for (const std::uint32_t triangle : triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3 corner = positions_[indices_[std::size_t{3} * triangle + c]];
            min = glm::min(min, corner);
            max = glm::max(max, corner);
        }
    nodes_[here].min = min;
    nodes_[here].max = max;
    if (count <= k_leaf_triangles) {
        nodes_[here].first = first;
        nodes_[here].count = count;
        return;
    }
    const glm::dvec3 size = glm::dvec3{max} - glm::dvec3{min};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = [&](std::uint32_t triangle) {
        const TriangleCorners t = corners(triangle);
        return t[0][axis] + t[1][axis] + t[2][axis];
    };
    // By number among equals, so that the tree is the same with every standard library.
    std::nth_element(triangles.begin(), triangles.begin() + count / 2, triangles.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double at_a = middle(a);
                         const double at_b = middle(b);
                         return at_a != at_b ? at_a < at_b : a < b;
                     });
    build(first, count / 2);
    nodes_[here].first = static_cast<std::uint32_t>(nodes_.size());
    build(first + count / 2, count - count / 2);
}

PointOnSurface Surface::nearest(glm::dvec3 point) const {
    PointOnSurface best;
    if (nodes_.empty()) return best;
    struct Open {
        std::uint32_t node;
        double distance_squared;
    };
    std::array<Open, 64> stack;  // halving 2³² triangles nests 32 deep
    std::size_t open = 0;
    stack[open++] = {0, distance_squared(point, nodes_[0].min, nodes_[0].max)};
    while (open > 0) {
        const Open next = stack[--open];
        if (next.distance_squared > best.place.distance * best.place.distance) continue;
        const Node& node = nodes_[next.node];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const PointOnTriangle candidate = nearest_on_triangle(point, corners(order_[i]));
            if (candidate.distance < best.place.distance) best = {order_[i], candidate};
        }
        if (node.count > 0) continue;
        Open near{next.node + 1, 0.0};
        Open far{node.first, 0.0};
        near.distance_squared = distance_squared(point, nodes_[near.node].min, nodes_[near.node].max);
        far.distance_squared = distance_squared(point, nodes_[far.node].min, nodes_[far.node].max);
        if (far.distance_squared < near.distance_squared) std::swap(near, far);
        stack[open++] = far;
        stack[open++] = near;
    }
    return best;
}

}  // namespace rambla::assets
