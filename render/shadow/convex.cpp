#include "render/shadow/convex.h"

namespace rambla::render::shadow {
namespace {

/// Inside is dot(normal, p) + offset ≥ 0. Doubles: boxes may be kilometres wide and frusta millimetres.
struct Plane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;

    [[nodiscard]] double distance(glm::dvec3 p) const { return glm::dot(normal, p) + offset; }
};

/// A quad clipped by six planes has at most ten corners.
struct Polygon {
    std::array<glm::dvec3, 10> corners{};
    std::size_t count = 0;

    void add(glm::dvec3 corner) {
        if (count < corners.size()) corners[count++] = corner;
    }
};

constexpr std::size_t k_faces = 6;
/// Faces of a hexahedron whose corners are numbered near −−, +−, ++, −+, far likewise.
constexpr std::array<std::array<std::size_t, 4>, k_faces> k_quads{
    {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Sutherland and Hodgman 1974.
Polygon clip(const Polygon& polygon, const Plane& plane) {
    Polygon clipped;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3 from = polygon.corners[i];
        const glm::dvec3 to = polygon.corners[(i + 1) % polygon.count];
        const double from_distance = plane.distance(from);
        const double to_distance = plane.distance(to);
        if (from_distance >= 0.0) clipped.add(from);
        if ((from_distance >= 0.0) != (to_distance >= 0.0)) {
            clipped.add(from + (to - from) * (from_distance / (from_distance - to_distance)));
        }
    }
    return clipped;
}

void add_faces(ConvexPoints& result, const std::array<glm::dvec3, 8>& body,
               const std::array<Plane, k_faces>& planes) {
    for (const auto& quad : k_quads) {
        Polygon polygon;
        for (const std::size_t corner : quad)
            polygon.add(body[corner]);
        for (const Plane& plane : planes)
            polygon = clip(polygon, plane);
        for (std::size_t i = 0; i < polygon.count; ++i) {
            result.points[result.count++] = glm::vec3{polygon.corners[i]};
        }
    }
}

/// Planes of a convex body's faces. A face that is no more than a line or a point (a slice that begins at the
/// eye) has no plane and cuts nothing.
std::array<Plane, k_faces> planes_of(const std::array<glm::dvec3, 8>& body) {
    glm::dvec3 centre{0.0};
    for (const glm::dvec3& corner : body)
        centre += corner / 8.0;
    std::array<Plane, k_faces> planes;
    for (std::size_t face = 0; face < k_faces; ++face) {
        const auto& quad = k_quads[face];
        const glm::dvec3 normal =
            glm::cross(body[quad[2]] - body[quad[0]], body[quad[3]] - body[quad[1]]);  // of the diagonals
        const double length = glm::length(normal);
        if (!(length > 0.0)) continue;
        const glm::dvec3 middle = 0.25 * (body[quad[0]] + body[quad[1]] + body[quad[2]] + body[quad[3]]);
        const double side = glm::dot(normal, centre - middle) < 0.0 ? -1.0 : 1.0;
        const glm::dvec3 unit = normal * (side / length);
        planes[face] = {unit, -glm::dot(unit, middle)};
    }
    return planes;
}

}  // namespace

ConvexPoints intersect(const std::array<glm::vec3, 8>& hexahedron, const assets::Bounds& box) {
    ConvexPoints result;
    if (box.empty()) return result;
    const glm::dvec3 low{box.min};
    const glm::dvec3 high{box.max};
    std::array<glm::dvec3, 8> frustum;
    for (std::size_t i = 0; i < 8; ++i)
        frustum[i] = glm::dvec3{hexahedron[i]};
    const std::array<glm::dvec3, 8> corners{
        glm::dvec3{low.x, low.y, low.z},    glm::dvec3{high.x, low.y, low.z},
        glm::dvec3{high.x, high.y, low.z},  glm::dvec3{low.x, high.y, low.z},
        glm::dvec3{low.x, low.y, high.z},   glm::dvec3{high.x, low.y, high.z},
        glm::dvec3{high.x, high.y, high.z}, glm::dvec3{low.x, high.y, high.z}};
    const std::array<Plane, k_faces> box_planes{
        Plane{{1.0, 0.0, 0.0}, -low.x},  Plane{{-1.0, 0.0, 0.0}, high.x}, Plane{{0.0, 1.0, 0.0}, -low.y},
        Plane{{0.0, -1.0, 0.0}, high.y}, Plane{{0.0, 0.0, 1.0}, -low.z},  Plane{{0.0, 0.0, -1.0}, high.z}};
    add_faces(result, frustum, box_planes);
    add_faces(result, corners, planes_of(frustum));
    return result;
}

}  // namespace rambla::render::shadow
