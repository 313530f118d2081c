#include "assets/process/bounds.h"

#include <cmath>
#include <limits>

namespace rambla::assets {

namespace {

struct Ball {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// Moves and grows the ball just so far that it holds each point in turn.
Ball grown(Ball ball, std::span<const glm::vec3> points) {
    for (const glm::vec3 point : points) {
        const glm::dvec3 to_point = glm::dvec3{point} - ball.centre;
        const double distance = glm::length(to_point);
        if (distance <= ball.radius) continue;
        const double radius = 0.5 * (ball.radius + distance);
        ball.centre += to_point * ((distance - ball.radius) / (2.0 * distance));
        ball.radius = radius;
    }
    return ball;
}

glm::dvec3 farthest_from(glm::dvec3 place, std::span<const glm::vec3> points) {
    glm::dvec3 farthest{points[0]};
    for (const glm::vec3 point : points)
        if (glm::distance(glm::dvec3{point}, place) > glm::distance(farthest, place)) farthest = point;
    return farthest;
}

/// As a float ball. The radius covers what rounding the centre may cost by its bound, half of 2⁻²³ of each
/// coordinate, not by measuring from the rounded centre: GCC 12 vectorises double → float → double to
/// nothing.
BoundingSphere holding(glm::dvec3 centre, std::span<const glm::vec3> points) {
    constexpr double k_float_rounding = 0x1p-24;
    const double radius =
        glm::distance(farthest_from(centre, points), centre) + k_float_rounding * glm::length(centre);
    return {glm::vec3{centre},
            std::nextafter(static_cast<float>(radius), std::numeric_limits<float>::infinity())};
}

}  // namespace

Bounds bounds_of(std::span<const glm::vec3> points) {
    Bounds bounds;
    for (const glm::vec3 point : points)
        bounds.expand(point);
    return bounds;
}

BoundingSphere bounding_sphere_of(std::span<const glm::vec3> points) {
    if (points.empty()) return {};
    const glm::dvec3 one = farthest_from(glm::dvec3{points[0]}, points);
    const glm::dvec3 other = farthest_from(one, points);
    Ball best = grown({0.5 * one + 0.5 * other, 0.5 * glm::distance(one, other)}, points);
    constexpr int k_rounds = 32;
    constexpr double k_shrink = 0.95;
    Ball ball = best;
    for (int round = 0; round < k_rounds; ++round) {
        ball = grown({ball.centre, k_shrink * ball.radius}, points);
        if (ball.radius < best.radius) best = ball;
    }
    const BoundingSphere around_best = holding(best.centre, points);
    const BoundingSphere around_box = holding(glm::dvec3{bounds_of(points).centre()}, points);
    return around_best.radius <= around_box.radius ? around_best : around_box;
}

}  // namespace rambla::assets
