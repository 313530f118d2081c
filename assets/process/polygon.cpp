#include "assets/process/polygon.h"

#include "assets/assert.h"

namespace rambla::assets {

glm::dvec3 Polygon::middle() const {
    glm::dvec3 sum{0.0};
    for (const glm::dvec3 point : points())
        sum += point;
    return sum / static_cast<double>(count_);
}

void Polygon::add(glm::dvec3 point) {
    RAMBLA_ASSERT(count_ < k_most_points, "callers halve polygons before they are full");
    points_[count_++] = point;
}

Polygon polygon_of(const TriangleCorners& triangle) {
    Polygon polygon;
    for (const glm::dvec3 corner : triangle)
        polygon.add(corner);
    return polygon;
}

std::pair<Polygon, Polygon> cut(const Polygon& polygon, const Plane& plane) {
    std::pair<Polygon, Polygon> parts;
    const std::span<const glm::dvec3> points = polygon.points();
    bool any_above = false;
    bool any_below = false;
    for (const glm::dvec3 point : points) {
        any_above = any_above || height(plane, point) > 0.0;
        any_below = any_below || height(plane, point) < 0.0;
    }
    if (!any_below) return {polygon, {}};
    if (!any_above) return {{}, polygon};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 here = points[i];
        const glm::dvec3 next = points[(i + 1) % points.size()];
        const double at_here = height(plane, here);
        const double at_next = height(plane, next);
        if (at_here >= 0.0) parts.first.add(here);
        if (at_here <= 0.0) parts.second.add(here);
        if ((at_here < 0.0 && at_next > 0.0) || (at_here > 0.0 && at_next < 0.0)) {
            const glm::dvec3 crossing = here + (next - here) * (at_here / (at_here - at_next));
            parts.first.add(crossing);
            parts.second.add(crossing);
        }
    }
    return parts;
}

Plane middle_plane(const Polygon& polygon) {
    const std::span<const glm::dvec3> points = polygon.points();
    glm::dvec3 longest{1.0, 0.0, 0.0};
    glm::dvec3 middle = polygon.middle();
    double length = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            if (const double found = glm::distance(points[i], points[j]); found > length) {
                length = found;
                longest = (points[j] - points[i]) / found;
                middle = 0.5 * points[i] + 0.5 * points[j];
            }
    return {longest, middle};
}

}  // namespace rambla::assets
