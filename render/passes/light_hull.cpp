#include "render/passes/light_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "render/passes/light_bins.h"
#include "render/passes/light_rectangle.h"

namespace rambla::render {
namespace {

constexpr double k_pi = std::numbers::pi;

/// From its middle to the vertices of a divided icosahedron whose faces touch the unit sphere. The middles of
/// an icosahedron's edges, moved out to the unit sphere, are the vertices of an icosidodecahedron of edge
/// 1/φ, whose triangles lie √(1 − 1/(3φ²)) from the middle; the other three of each face have shorter edges,
/// and lie farther out. The reciprocal is √((9 − 3√5)/2), 1.0705.
const double k_sphere_vertex = std::sqrt((9.0 - 3.0 * std::sqrt(5.0)) / 2.0);

constexpr std::uint32_t k_cone_sides = 8;
/// From the axis to the corners of a regular polygon whose sides are 1 away from it.
const double k_cone_corner = 1.0 / std::cos(k_pi / k_cone_sides);
constexpr double k_widest_cone_rad = k_pi / 3.0;
/// The lid's radius, as a share of the rim's. The bevel meets the lid R·tan(θ/4) from the axis, and
/// tan(θ/4)/(2·sin(θ/2)) grows with θ, from 1/4: its value at 60° will do for all.
const double k_lid_share = std::tan(k_pi / 12.0);

/// Hulls are a little larger than they must be, so that no pixel whose light counts lies at the edge of one,
/// where rounding decides whether it is drawn: of vertices to a 256th of a pixel, which is 6e-6 of the
/// distance where a pixel is 1.6e-3 rad wide; of positions, 1e-7 of it; and of depth. Light fades towards its
/// radius, but cones may end in a step.
constexpr double k_slack_of_radius = 1e-3;
constexpr double k_slack_of_distance = 1e-5;
constexpr double k_slack_rad = 1e-3;
/// Shaders compare cosines, of unit vectors that are rounded.
constexpr double k_slack_cos = 1e-6;

constexpr double k_unit_length_tolerance = 1e-3;

using Triangle = std::array<std::uint32_t, 3>;

/// Of the unit sphere.
struct Icosahedron {
    std::vector<glm::dvec3> vertices;
    std::vector<Triangle> faces{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

    Icosahedron() {
        constexpr double g = std::numbers::phi;
        for (const glm::dvec3 corner : {glm::dvec3{-1, g, 0},
                                        {1, g, 0},
                                        {-1, -g, 0},
                                        {1, -g, 0},
                                        {0, -1, g},
                                        {0, 1, g},
                                        {0, -1, -g},
                                        {0, 1, -g},
                                        {g, 0, -1},
                                        {g, 0, 1},
                                        {-g, 0, -1},
                                        {-g, 0, 1}})
            vertices.push_back(glm::normalize(corner));
    }
};

HullMesh sphere_mesh() {
    Icosahedron solid;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto next = static_cast<std::uint32_t>(solid.vertices.size());
        const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), next);
        if (is_new) solid.vertices.push_back(glm::normalize(solid.vertices[a] + solid.vertices[b]));
        return found->second;
    };
    HullMesh mesh;
    for (const auto& [a, b, c] : solid.faces) {
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        mesh.indices.insert(mesh.indices.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    for (const glm::dvec3& vertex : solid.vertices)
        mesh.vertices.emplace_back(glm::vec3{k_sphere_vertex * vertex}, 0.0f);
    return mesh;
}

HullMesh cone_mesh() {
    HullMesh mesh;
    mesh.vertices.emplace_back(0.0f);
    for (std::uint32_t i = 0; i < k_cone_sides; ++i) {
        const double angle = 2.0 * k_pi * i / k_cone_sides;
        const glm::vec2 corner{k_cone_corner * glm::dvec2{std::cos(angle), std::sin(angle)}};
        mesh.vertices.emplace_back(corner, 1.0f, 0.0f);
        mesh.vertices.emplace_back(static_cast<float>(k_lid_share) * corner, 0.0f, 1.0f);
    }
    const auto rim = [](std::uint32_t i) {
        return 1 + 2 * (i % k_cone_sides);
    };
    const auto lid = [&](std::uint32_t i) {
        return rim(i) + 1;
    };
    for (std::uint32_t i = 0; i < k_cone_sides; ++i) {
        mesh.indices.insert(mesh.indices.end(), {0, rim(i + 1), rim(i)});
        mesh.indices.insert(mesh.indices.end(), {rim(i), rim(i + 1), lid(i + 1), rim(i), lid(i + 1), lid(i)});
        if (i >= 2) mesh.indices.insert(mesh.indices.end(), {lid(0), lid(i - 1), lid(i)});
    }
    return mesh;
}

/// Between the axis and what the light reaches; π for what is no spot.
double half_angle_rad(const systems::FrameLight& light) {
    const double length = glm::length(glm::dvec3{light.direction});
    if (!(std::fabs(length - 1.0) <= k_unit_length_tolerance)) return k_pi;
    return std::acos(std::clamp(light.cos_outer - k_slack_cos, -1.0, 1.0)) + k_slack_rad;
}

Hull sphere_hull(glm::dvec3 centre_m, double radius_m) {
    Hull hull;
    hull.shape = HullShape::sphere;
    hull.place.origin = glm::vec4{glm::vec3{centre_m}, 1.0f};
    hull.place.axes = glm::mat4{0.0f};
    for (int axis = 0; axis < 3; ++axis)
        hull.place.axes[axis][axis] = static_cast<float>(radius_m);
    return hull;
}

/// @param direction  unit length
Hull cone_hull(glm::dvec3 apex_m, glm::dvec3 direction, double half_angle, double radius_m) {
    const glm::dvec3 least = std::fabs(direction.x) < 0.7 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 side = glm::normalize(glm::cross(direction, least));
    const double rim_m = 2.0 * radius_m * std::sin(0.5 * half_angle);
    const double rim_height_m = radius_m * std::cos(half_angle) / std::cos(0.5 * half_angle);
    Hull hull;
    hull.shape = HullShape::cone;
    hull.place.origin = glm::vec4{glm::vec3{apex_m}, 1.0f};
    hull.place.axes = {glm::vec4{rim_m * side, 0.0}, glm::vec4{rim_m * glm::cross(direction, side), 0.0},
                       glm::vec4{rim_height_m * direction, 0.0}, glm::vec4{radius_m * direction, 0.0}};
    return hull;
}

/// A cone's hull, seen along a plane through its axis and turned around that.
struct ConeProfile {
    glm::dvec3 apex_m;
    glm::dvec3 direction;
    glm::dvec2 rim_m;  ///< height along the direction, distance from the axis
    glm::dvec2 lid_m;

    explicit ConeProfile(const shared::LightHull& hull)
        : apex_m{hull.origin},
          direction{glm::normalize(glm::dvec3{hull.axes[3]})},
          rim_m{glm::length(glm::dvec3{hull.axes[2]}), k_cone_corner * glm::length(glm::dvec3{hull.axes[0]})},
          lid_m{glm::length(glm::dvec3{hull.axes[3]}), k_lid_share * rim_m.y} {}
};

double sphere_radius_m(const shared::LightHull& hull) {
    return k_sphere_vertex * hull.axes[0][0];
}

/// How far `point` lies on the left of the line from a to b.
double left_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 point) {
    const glm::dvec2 along = b - a;
    const glm::dvec2 offset = point - a;
    return (along.x * offset.y - along.y * offset.x) / glm::length(along);
}

/// From the eye to the hull at least; negative inside.
double eye_distance_m(const Hull& hull) {
    if (hull.shape == HullShape::sphere)
        return glm::length(glm::dvec3{hull.place.origin}) - sphere_radius_m(hull.place);
    const ConeProfile cone{hull.place};
    const double height = -glm::dot(cone.apex_m, cone.direction);
    const glm::dvec2 eye{height, glm::length(cone.apex_m + height * cone.direction)};
    return std::max(
        {left_of({0, 0}, cone.rim_m, eye), left_of(cone.rim_m, cone.lid_m, eye), eye.x - cone.lid_m.x});
}

/// Of the hull's point nearest to an orthographic view, in its space, at most.
double nearest_z(const systems::FrameView& view, const Hull& hull) {
    const glm::dvec3 towards_view{glm::transpose(glm::mat3{view.view_from_world})[2]};
    const double origin_z = glm::dot(glm::dvec3{hull.place.origin}, towards_view);
    if (hull.shape == HullShape::sphere) return origin_z + sphere_radius_m(hull.place);
    const ConeProfile cone{hull.place};
    const double along = glm::dot(cone.direction, towards_view);
    const glm::dvec2 rise{along, std::sqrt(std::max(0.0, 1.0 - along * along))};
    return origin_z + std::max({0.0, glm::dot(rise, cone.rim_m), glm::dot(rise, cone.lid_m)});
}

/// From the eye to the farthest corner of a perspective's near plane.
double near_corner_m(const systems::FrameView& view) {
    const glm::mat4& p = view.clip_from_view;
    const glm::dvec2 slope{(1.0 + std::fabs(p[2][0])) / p[0][0], (1.0 + std::fabs(p[2][1])) / p[1][1]};
    return -near_plane_z(view) * std::sqrt(1.0 + glm::dot(slope, slope));
}

}  // namespace

HullMesh hull_mesh(HullShape shape) {
    return shape == HullShape::sphere ? sphere_mesh() : cone_mesh();
}

Hull light_hull(const systems::FrameLight& light, std::uint32_t row) {
    const glm::dvec3 place{light.position_m};
    const double radius = std::min(light.radius_m, k_farthest_light_m);
    const double slack = k_slack_of_radius * radius + k_slack_of_distance * glm::length(place);
    const double half_angle = half_angle_rad(light);
    Hull hull;
    if (half_angle <= k_widest_cone_rad) {
        // What is within the radius of the light is within that and the slack of an apex that lies behind it.
        const glm::dvec3 direction = glm::normalize(glm::dvec3{light.direction});
        hull = cone_hull(place - slack * direction, direction, half_angle, radius + 2.0 * slack);
    } else {
        hull = sphere_hull(place, radius + slack);
    }
    hull.place.light = row;
    return hull;
}

bool reaches_near_plane(const systems::FrameView& view, const Hull& hull) {
    return view.orthographic ? nearest_z(view, hull) >= near_plane_z(view)
                             : eye_distance_m(hull) <= near_corner_m(view);
}

}  // namespace rambla::render
