#include "render/passes/light_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace {

using namespace rambla;
using render::Hull;
using render::HullMesh;
using render::HullShape;

/// Outside: normal·p > offset.
struct Face {
    glm::dvec3 normal;
    double offset = 0.0;
};

/// A hull as the GPU draws it.
struct Solid {
    std::vector<glm::dvec3> vertices;
    std::vector<Face> faces;

    explicit Solid(const Hull& hull) {
        const HullMesh mesh = render::hull_mesh(hull.shape);
        for (const glm::vec4& shares : mesh.vertices)
            vertices.emplace_back(glm::dvec4{hull.place.origin} +
                                  glm::dmat4{hull.place.axes} * glm::dvec4{shares});
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = vertices[mesh.indices[i]];
            const glm::dvec3 normal = glm::normalize(
                glm::cross(vertices[mesh.indices[i + 1]] - a, vertices[mesh.indices[i + 2]] - a));
            faces.push_back({normal, glm::dot(normal, a)});
        }
    }

    /// How far the point lies outside of the face that it is farthest outside of; negative inside.
    [[nodiscard]] double outside_m(glm::dvec3 point) const {
        double most = -std::numeric_limits<double>::infinity();
        for (const Face& face : faces)
            most = std::max(most, glm::dot(face.normal, point) - face.offset);
        return most;
    }
};

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
}

/// @param cos_outer  −2: a point light
systems::FrameLight random_light(std::mt19937& random, float cos_outer) {
    std::uniform_real_distribution<float> place{-30.0f, 30.0f};
    return {.position_m = {place(random), place(random), place(random)},
            .radius_m = std::exp(std::uniform_real_distribution<float>{-3.0f, 4.0f}(random)),
            .intensity = glm::vec3{1.0f},
            .cos_outer = cos_outer,
            .direction = glm::vec3{random_direction(random)},
            .cos_inner = cos_outer};
}

constexpr float k_cosines[] = {-2.0f, 0.51f, 0.6f, 0.9f, 0.999f, 0.999999f, 1.0f};

TEST(LightHull, IsClosedConvexAndFacesOutwards) {
    for (const HullShape shape : {HullShape::sphere, HullShape::cone}) {
        const HullMesh mesh = render::hull_mesh(shape);
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
            EXPECT_TRUE(edges.emplace(mesh.indices[i], mesh.indices[next]).second) << "each way once";
        }
        for (const auto& [from, to] : edges)
            EXPECT_TRUE(edges.contains({to, from})) << from << " to " << to;
        EXPECT_EQ(mesh.vertices.size() + mesh.indices.size() / 3, edges.size() / 2 + 2) << "Euler";
    }
    std::mt19937 random{1};
    for (const float cos_outer : k_cosines) {
        const systems::FrameLight light = random_light(random, cos_outer);
        const Solid solid{render::light_hull(light, 0)};
        // Vertices are floats: 2^-24 of up to 52 m, once for the origin and once for each axis.
        for (const glm::dvec3& vertex : solid.vertices)
            EXPECT_LE(solid.outside_m(vertex), 2e-5 + 1e-6 * light.radius_m) << cos_outer;
        const glm::dvec3 middle =
            glm::dvec3{light.position_m} +
            (cos_outer < 0.0f ? 0.0 : 0.5 * light.radius_m) * glm::dvec3{light.direction};
        EXPECT_LT(solid.outside_m(middle), 0.0) << cos_outer;
    }
}

TEST(LightHull, HoldsEveryPointOfASphere) {
    std::mt19937 random{2};
    for (int trial = 0; trial < 20; ++trial) {
        const systems::FrameLight light = random_light(random, -2.0f);
        const Hull hull = render::light_hull(light, 7);
        EXPECT_EQ(hull.shape, HullShape::sphere);
        EXPECT_EQ(hull.place.light, 7u);
        const Solid solid{hull};
        for (int i = 0; i < 10'000; ++i) {
            const glm::dvec3 point =
                glm::dvec3{light.position_m} + double{light.radius_m} * random_direction(random);
            ASSERT_LT(solid.outside_m(point), 0.0) << trial;
        }
    }
}

TEST(LightHull, HoldsEveryPointOfACone) {
    std::mt19937 random{3};
    std::uniform_real_distribution<double> uniform;
    for (const float cos_outer : k_cosines) {
        if (cos_outer < 0.0f) continue;
        const systems::FrameLight light = random_light(random, cos_outer);
        const Hull hull = render::light_hull(light, 0);
        EXPECT_EQ(hull.shape, HullShape::cone) << cos_outer;
        const Solid solid{hull};
        const glm::dvec3 axis = glm::normalize(glm::dvec3{light.direction});
        for (int i = 0; i < 10'000; ++i) {
            // A third of the points each on the rim, on the cone, and anywhere in it.
            const double cosine = i % 3 == 2 ? glm::mix(double{cos_outer}, 1.0, uniform(random)) : cos_outer;
            const double distance = i % 3 == 0 ? 1.0 : uniform(random);
            const glm::dvec3 across = glm::normalize(glm::cross(axis, random_direction(random)));
            const glm::dvec3 direction = cosine * axis + std::sqrt(1.0 - cosine * cosine) * across;
            const glm::dvec3 point = glm::dvec3{light.position_m} + distance * light.radius_m * direction;
            ASSERT_LT(solid.outside_m(point), 0.0) << cos_outer << " at " << distance;
        }
    }
}

TEST(LightHull, TouchesWhatItHolds) {
    const systems::FrameLight point{.position_m = glm::vec3{0.0f}, .radius_m = 10.0f};
    for (const Face& face : Solid{render::light_hull(point, 0)}.faces) {
        EXPECT_GE(face.offset, 10.01 - 1e-5) << "a thousandth more, but for the rounding of vertices";
        EXPECT_LT(face.offset, 10.01 * 1.03) << "the others of a divided face lie 2.3 % farther out";
    }
    const double nearest = -Solid{render::light_hull(point, 0)}.outside_m({0, 0, 0});
    EXPECT_NEAR(nearest, 10.01, 1e-5);

    systems::FrameLight spot = point;
    spot.direction = {0, 0, -1};
    for (const double angle_deg : {5.0, 30.0, 59.0}) {
        const double angle = glm::radians(angle_deg);
        spot.cos_outer = static_cast<float>(std::cos(angle));
        const Solid solid{render::light_hull(spot, 0)};
        // Where a side touches the cone: corners are at multiples of 45°.
        const auto outside_m = [&](double half_angle) {
            const glm::dvec2 across{std::cos(glm::radians(22.5)), std::sin(glm::radians(22.5))};
            return solid.outside_m(10.0 * glm::dvec3{std::sin(half_angle) * across, -std::cos(half_angle)});
        };
        // Slack: 0.001 rad of the angle, 0.01 m of the apex, which lies behind, and twice that of the radius.
        EXPECT_LT(outside_m(angle + 0.001), 0.0) << angle_deg;
        EXPECT_GT(outside_m(angle + 0.004), 0.0) << angle_deg;
        EXPECT_LT(solid.outside_m({0, 0, -10.005}), 0.0) << angle_deg;
        EXPECT_GT(solid.outside_m({0, 0, -10.015}), 0.0) << angle_deg;
    }
    // A cosine that is off by 1e-6 is an angle of 1.4e-3.
    spot.cos_outer = 1.0f;
    EXPECT_LT((Solid{render::light_hull(spot, 0)}.outside_m({0.013, 0, -9.9})), 0.0);
}

TEST(LightHull, IsASphereWhereNoConeIsTighter) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    systems::FrameLight light{.radius_m = 5.0f, .direction = {0, -1, 0}};
    for (const float cos_outer : {-2.0f, -1.0f, 0.0f, 0.49f, 0.5f, nan}) {
        light.cos_outer = cos_outer;
        EXPECT_EQ(render::light_hull(light, 0).shape, HullShape::sphere) << cos_outer;
    }
    light.cos_outer = 0.9f;
    EXPECT_EQ(render::light_hull(light, 0).shape, HullShape::cone);
    for (const glm::vec3 none : {glm::vec3{0.0f}, glm::vec3{nan, 0, 0}, glm::vec3{0, -2, 0}}) {
        light.direction = none;
        EXPECT_EQ(render::light_hull(light, 0).shape, HullShape::sphere) << none.y;
    }
}

TEST(LightHull, IsFiniteForLightsOfAnySize) {
    for (const float radius_m : {1e-6f, 1e6f, 1e30f, std::numeric_limits<float>::infinity()}) {
        for (const float cos_outer : {-2.0f, 0.6f, 1.0f, 1.5f}) {
            const Solid solid{render::light_hull(
                {.radius_m = radius_m, .cos_outer = cos_outer, .direction = {0, 0, -1}}, 0)};
            const double reach = std::min(double{radius_m}, 1e6);
            EXPECT_LT(solid.outside_m({0, 0, -reach}), 0.0) << radius_m << " " << cos_outer;
            EXPECT_LT(solid.outside_m({0, 0, 0}), 0.0) << radius_m << " " << cos_outer;
            for (const glm::dvec3& vertex : solid.vertices)
                EXPECT_LT(glm::length(vertex), 1.3 * reach) << radius_m << " " << cos_outer;
        }
    }
}

systems::FrameView perspective_view() {
    systems::FrameView view;
    view.view_from_world = glm::lookAt(glm::vec3{0.0f}, glm::vec3{0.3f, -0.2f, -1.0f}, glm::vec3{0, 1, 0});
    view.clip_from_view = glm::mat4{0.0f};
    view.clip_from_view[0][0] = 1.2f;
    view.clip_from_view[1][1] = 1.8f;
    view.clip_from_view[2][0] = 0.1f;
    view.clip_from_view[2][3] = -1.0f;
    view.clip_from_view[3][2] = 0.5f;
    return view;
}

systems::FrameView orthographic_view() {
    systems::FrameView view = perspective_view();
    view.orthographic = true;
    view.clip_from_view = glm::mat4{1.0f};
    view.clip_from_view[0][0] = 0.1f;
    view.clip_from_view[1][1] = 0.2f;
    view.clip_from_view[2][2] = 0.01f;  // depth 1 at z = −0.5, 0 at z = −100.5
    view.clip_from_view[3][2] = 1.005f;
    return view;
}

/// Points all over what the view sees of its near plane, camera-relative.
std::vector<glm::dvec3> near_plane_points(const systems::FrameView& view) {
    std::vector<glm::dvec3> points;
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4{view.clip_from_view * view.view_from_world});
    for (int y = -10; y <= 10; ++y) {
        for (int x = -10; x <= 10; ++x) {
            const glm::dvec4 p = world_from_clip * glm::dvec4{0.1 * x, 0.1 * y, 1.0, 1.0};
            points.push_back(glm::dvec3{p} / p.w);
        }
    }
    return points;
}

TEST(LightHull, ReachesTheNearPlaneWhereThatCutsIt) {
    std::mt19937 random{4};
    for (const systems::FrameView& view : {perspective_view(), orthographic_view()}) {
        const std::vector<glm::dvec3> near_points = near_plane_points(view);
        std::map<std::pair<bool, bool>, int> found;
        for (int trial = 0; trial < 4000; ++trial) {
            systems::FrameLight light = random_light(random, k_cosines[trial % std::size(k_cosines)]);
            light.position_m *= 0.2f;
            const Hull hull = render::light_hull(light, 0);
            const Solid solid{hull};
            const bool is_cut = std::any_of(near_points.begin(), near_points.end(),
                                            [&](glm::dvec3 p) { return solid.outside_m(p) <= 0.0; });
            const bool reaches = render::reaches_near_plane(view, hull);
            ++found[{is_cut, reaches}];
            ASSERT_TRUE(reaches || !is_cut) << trial;
        }
        EXPECT_GT((found[{true, true}]), 200);
        EXPECT_GT((found[{false, false}]), 200) << "and not where it is far away";
    }
}

TEST(LightHull, ReachesTheNearPlaneFromAsFarAsItsCorners) {
    systems::FrameView view;
    view.clip_from_view = glm::mat4{0.0f};
    view.clip_from_view[0][0] = 1.0f;
    view.clip_from_view[1][1] = 1.0f;
    view.clip_from_view[2][0] = 0.5f;
    view.clip_from_view[2][3] = -1.0f;
    view.clip_from_view[3][2] = 0.1f;
    const double corner_m = 0.1 * std::sqrt(1.0 + 1.5 * 1.5 + 1.0);
    const auto reaches = [&](systems::FrameLight light, double distance_m) {
        light.position_m = {0, 0, -distance_m};
        return render::reaches_near_plane(view, render::light_hull(light, 0));
    };
    const systems::FrameLight point{.radius_m = 2.0f};
    // Vertices of the hull lie √((9 − 3√5)/2) · (2.002 m and 1e-5 of the distance) from its middle.
    const double vertex_m = 1.0704663 * (2.002 + 1e-5 * 2.3);
    EXPECT_TRUE(reaches(point, vertex_m + corner_m - 1e-4));
    EXPECT_FALSE(reaches(point, vertex_m + corner_m + 1e-4));
    // The lid lies 2.004 m and 2e-5 of the distance from the apex, which lies 0.002 m behind the lamp.
    systems::FrameLight spot{.radius_m = 2.0f, .cos_outer = 0.8f, .direction = {0, 0, 1}};
    const double lid_m = 2.002 + 1e-5 * 2.2;
    EXPECT_TRUE(reaches(spot, lid_m + corner_m - 1e-4));
    EXPECT_FALSE(reaches(spot, lid_m + corner_m + 1e-4));
    spot.direction = {0, 0, -1};
    EXPECT_TRUE(reaches(spot, 0.0)) << "the eye at the lamp";
    EXPECT_TRUE(reaches(spot, -1.0)) << "the eye in its light";

    view.orthographic = true;
    view.clip_from_view = glm::mat4{1.0f};
    view.clip_from_view[2][2] = 0.01f;
    view.clip_from_view[3][2] = 1.01f;  // the near plane at z = −1
    EXPECT_TRUE(reaches(point, 1.0 + vertex_m - 1e-4));
    EXPECT_FALSE(reaches(point, 1.0 + vertex_m + 1e-4));
    EXPECT_TRUE(reaches(spot, 1.0)) << "its apex lies a little behind it";
    EXPECT_FALSE(reaches(spot, 1.01));
    spot.direction = {0, 0, 1};
    EXPECT_TRUE(reaches(spot, 1.0 + lid_m - 1e-4));
    EXPECT_FALSE(reaches(spot, 1.0 + lid_m + 1e-4));
}

}  // namespace
