#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <set>

#include "assets/trace/placed_scene.h"
#include "unit/assets/trace_support.h"

namespace rambla::assets::test {
namespace {

constexpr double k_exact = 1e-13;  // a few roundings of doubles of size 1

TEST(Tracer, DistancesAndNormalsOfASquareAreExact) {
    TracedWorld world;
    world.place(facing_square(), moved({0, 0, -3}));
    const Tracer tracer{world.scene};
    const auto hit = tracer.first_hit({.origin_m = {0.25, 0.5, 2}, .direction = {0, 0, -2}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->object, 100u);
    EXPECT_EQ(hit->instance, 0u);
    EXPECT_TRUE(hit->front);
    EXPECT_DOUBLE_EQ(hit->t, 2.5);
    EXPECT_DOUBLE_EQ(hit->distance_m, 5.0);
    EXPECT_NEAR(glm::distance(hit->position_m, {0.25, 0.5, -3}), 0.0, k_exact);
    EXPECT_EQ(hit->geometric_normal, (glm::dvec3{0, 0, 1}));
    EXPECT_NEAR(glm::distance(hit->uv0, {0.625, 0.25}), 0.0, k_exact);
    EXPECT_EQ(hit->triangle, 1u) << "above the diagonal";
    EXPECT_NEAR(hit->barycentric.x, 0.625, k_exact);
    EXPECT_NEAR(hit->barycentric.y, 0.125, k_exact);
    EXPECT_FALSE(tracer.first_hit({.origin_m = {1.25, 0.5, 2}}));
}

// Thin walls at an angle to everything: Embree's own distances would be wrong in the 7th digit.
TEST(Tracer, DistancesHaveTheDigitsOfDoubles) {
    TracedWorld world;
    const glm::mat4 placed = moved({310.7f, -20.3f, 911.1f}) *
                             glm::mat4_cast(glm::normalize(glm::quat{0.7f, 0.2f, -0.5f, 0.3f})) *
                             scaled({40, 30, 1});
    world.place(facing_square(), placed);
    const Tracer tracer{world.scene};
    const glm::dmat4 map{placed};
    const glm::dvec3 on_plane{map * glm::dvec4{0.1, -0.3, 0, 1}};
    const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3{map[0]}, glm::dvec3{map[1]}));
    const glm::dvec3 origin = on_plane + 500.0 * normal + 123.0 * glm::dvec3{map[0]} / 40.0;
    const glm::dvec3 direction = glm::normalize(on_plane - origin);
    const auto hit = tracer.first_hit({.origin_m = origin, .direction = direction});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance_m, glm::distance(on_plane, origin), 1e-11);  // 1000 m · 2⁻⁵² · a few
    EXPECT_LT(glm::distance(hit->position_m, on_plane), 1e-11);
    EXPECT_LT(glm::distance(hit->geometric_normal, normal), 1e-12);
}

TEST(Tracer, AGlobeIsASphereAsFarAsItsFacesAre) {
    TracedWorld world;
    world.place(globe(64), moved({0, 0, -5}));
    const Tracer tracer{world.scene};
    const double sagitta = 1.0 - std::cos(k_pi / 64.0) + 1e-6;
    int hits = 0;
    for (int y = -20; y <= 20; ++y) {
        for (int x = -20; x <= 20; ++x) {
            const glm::dvec3 direction = glm::normalize(glm::dvec3{0.0101 * x, 0.0101 * y, -1});
            const double along = 5.0 * -direction.z;  // to the foot of the centre
            const double aside2 = 25.0 - along * along;
            const auto hit = tracer.first_hit({.direction = direction});
            if (aside2 > 1.0) {
                EXPECT_FALSE(hit);
            } else if (aside2 < 0.9) {
                ASSERT_TRUE(hit) << x << " " << y;
                ++hits;
                const double to_sphere = along - std::sqrt(1.0 - aside2);
                EXPECT_GE(hit->distance_m, to_sphere - 1e-6);
                EXPECT_LE(hit->distance_m, to_sphere + 4.0 * sagitta);  // rays are at most 72° aslant
                const glm::dvec3 outwards = glm::normalize(hit->position_m - glm::dvec3{0, 0, -5});
                EXPECT_LT(glm::distance(hit->shading_normal, outwards), 2e-3);     // linear between normals
                EXPECT_LT(glm::distance(hit->geometric_normal, outwards), 0.035);  // half a face: 1.4° + 1.4°
            }
        }
    }
    EXPECT_GT(hits, 1000);
}

TEST(Tracer, BackFacesOfSingleSidedSurfacesAreNotSeen) {
    TracedWorld world;
    const std::uint32_t both = world.material({.double_sided = true});
    const std::uint32_t square = world.mesh(facing_square());
    world.place(square, moved({0, 0, -1}) * glm::rotate(glm::mat4{1.0f}, 3.14159265f, {0, 1, 0}));
    world.place(square, moved({0, 0, -2}) * glm::rotate(glm::mat4{1.0f}, 3.14159265f, {0, 1, 0}), both);
    const Tracer tracer{world.scene};
    TraceRay ray{.origin_m = {0.1, 0.2, 0}};
    const auto seen = tracer.first_hit(ray);
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->instance, 1u);
    EXPECT_FALSE(seen->front);
    EXPECT_GT(seen->geometric_normal.z, 0.99) << "normals are those of the side that is hit";
    EXPECT_GT(seen->shading_normal.z, 0.99);
    ray.faces = TraceFaces::lit;
    EXPECT_EQ(tracer.first_hit(ray)->instance, 0u) << "the light sees the face that the eye does not";
    ray.faces = TraceFaces::all;
    EXPECT_EQ(tracer.first_hit(ray)->instance, 0u);
    ray = {.origin_m = {0.1, 0.2, -3}, .direction = {0, 0, 1}, .faces = TraceFaces::lit};
    EXPECT_EQ(tracer.first_hit(ray)->instance, 1u) << "what is double-sided stops light too";
}

TEST(Tracer, MirroringMapsKeepTheFrontInFront) {
    for (const glm::vec3 scale : {glm::vec3{1, 1, 1}, glm::vec3{-1, 1, 1}, glm::vec3{-2, -0.5f, -3}}) {
        TracedWorld world;
        world.place(globe(16), moved({0, 0, -9}) * scaled(scale));
        world.place(cube(), moved({30, 0, -9}) * scaled(scale));
        const Tracer tracer{world.scene};
        for (const double x : {0.1, 30.1}) {
            const auto hit = tracer.first_hit({.origin_m = {x, 0.1, 0}});
            ASSERT_TRUE(hit);
            EXPECT_TRUE(hit->front);
            EXPECT_GT(hit->position_m.z, -9.0) << "the near side";
            EXPECT_GT(hit->geometric_normal.z, 0.4);
            EXPECT_GT(hit->shading_normal.z, 0.4);
        }
    }
    TracedWorld world;
    world.place(facing_square(), moved({0, 0, -1})).clockwise = true;
    EXPECT_FALSE(Tracer{world.scene}.first_hit({.origin_m = {0.1, 0.2, 0}}));
}

// A sheared unit sphere: ray and surface are taken back to the sphere's space, where the answer is known.
TEST(Tracer, ShearedAndSqueezedInstancesAreHitWhereTheyAre) {
    glm::mat4 map{1.0f};
    map[1] = {0.8f, 0.5f, -0.3f, 0};
    map[2] = {0.1f, 0.9f, 2.0f, 0};
    map[3] = {3, -1, -12, 1};
    TracedWorld world;
    world.place(cube(), map);
    const Tracer tracer{world.scene};
    const glm::dmat4 local_from_world = glm::inverse(glm::dmat4{map});
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 direction{0.25 + 0.02 * (i % 20 - 10), -0.08 + 0.02 * (i / 20 - 10.0), -1.0};
        const glm::dvec3 origin{local_from_world * glm::dvec4{0, 0, 0, 1}};
        const glm::dvec3 d{local_from_world * glm::dvec4{direction, 0}};
        // Slabs of the cube ±1.
        double near = -1e30, far = 1e30;
        int axis_in = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (-1.0 - origin[axis]) / d[axis], b = (1.0 - origin[axis]) / d[axis];
            if (std::min(a, b) > near) axis_in = axis;
            near = std::max(near, std::min(a, b));
            far = std::min(far, std::max(a, b));
        }
        const auto hit = tracer.first_hit({.direction = direction});
        if (std::abs(far - near) < 1e-4) continue;  // an edge
        ASSERT_EQ(hit.has_value(), near < far) << i;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(hit->t, near, 1e-12 * near);
        glm::dvec3 local_normal{0.0};
        local_normal[axis_in] = d[axis_in] > 0.0 ? -1.0 : 1.0;
        const glm::dvec3 normal =
            glm::normalize(glm::dvec3{glm::transpose(local_from_world) * glm::dvec4{local_normal, 0}});
        EXPECT_LT(glm::distance(hit->geometric_normal, normal), 1e-12);
    }
    EXPECT_GT(hits, 60);
}

// By the formula of mesh.vert.glsl: normals of unit length in the world are what is mixed.
TEST(Tracer, ShadingNormalsAreMixedAsTheRendererDoes) {
    TracedWorld world;
    Mesh mesh = facing_square();
    mesh.normals = {{-0.6f, 0, 0.8f}, {0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}};
    world.place(std::move(mesh), moved({0, 0, -2}) * scaled({0.25f, 1, -1}),
                world.material({.double_sided = true}));
    const Tracer tracer{world.scene};
    const auto hit = tracer.first_hit({.origin_m = {0.1, -0.3, 0}});  // (0.4, −0.3) of the first triangle
    ASSERT_TRUE(hit);
    ASSERT_EQ(hit->triangle, 0u);
    EXPECT_FALSE(hit->front) << "z is mirrored: its front looks away";
    // Inverse transpose: x by 4, z by −1; mirrored back to the side that is seen.
    const glm::dvec3 a = glm::normalize(glm::dvec3{-2.4, 0, -0.8}), b{0, 0, -1},
                     c = glm::normalize(glm::dvec3{2.4, 0, -0.8});
    const glm::dvec3 mixed = 0.3 * a + 0.35 * b + 0.35 * c;
    EXPECT_LT(glm::distance(hit->shading_normal, -glm::normalize(mixed)), 1e-6);  // of float normals
}

TEST(Tracer, FlattenedInstancesAreStillThere) {
    TracedWorld world;
    world.place(globe(16), moved({0, 0, -4}) * scaled({1, 1, 0}));
    world.place(cube(), moved({5, 0, -4}) * scaled({1, 1, 1e-7f}));
    world.place(facing_square(), moved({10, 0, -4}) * scaled({0, 0, 0}));
    const Tracer tracer{world.scene};
    const auto disc = tracer.first_hit({.origin_m = {0.3, 0.2, 0}, .faces = TraceFaces::all});
    ASSERT_TRUE(disc);
    EXPECT_NEAR(disc->distance_m, 4.0, k_exact);
    const auto sheet = tracer.first_hit({.origin_m = {5.3, 0.2, 0}});
    ASSERT_TRUE(sheet);
    EXPECT_NEAR(sheet->distance_m, 4.0 - static_cast<double>(1e-7f), k_exact);
    EXPECT_FALSE(tracer.first_hit({.origin_m = {10, 0, 0}, .faces = TraceFaces::all}));
}

TEST(Tracer, EndsOfARayAreKeptTo) {
    TracedWorld world;
    const std::uint32_t square = world.mesh(facing_square());
    for (const float z : {-1.0f, -2.0f, -3.0f})
        world.place(square, moved({0, 0, z}));
    const Tracer tracer{world.scene};
    TraceRay ray{.origin_m = {0.1, 0.2, 0}};
    const auto first = [&](double t_min, double t_max) {
        ray.t_min = t_min;
        ray.t_max = t_max;
        const auto hit = tracer.first_hit(ray);
        EXPECT_EQ(hit.has_value(), tracer.is_stopped(ray));
        return hit ? hit->object : 0;
    };
    EXPECT_EQ(first(0.0, 10.0), 100u);
    EXPECT_EQ(first(1.0, 10.0), 101u) << "ends do not belong to it";
    EXPECT_EQ(first(1.0 - 1e-12, 10.0), 100u);
    EXPECT_EQ(first(1.0 + 1e-12, 2.0), 0u);
    EXPECT_EQ(first(1.0 + 1e-12, 2.0 + 1e-12), 101u);
    EXPECT_EQ(first(2.5, 2.9), 0u);
    EXPECT_EQ(first(-5.0, 10.0), 100u);
    EXPECT_EQ(first(3.0, 2.0), 0u);
}

TEST(Tracer, RaysMeetOnlyInstancesOfTheirKind) {
    TracedWorld world;
    const std::uint32_t square = world.mesh(facing_square());
    world.place(square, moved({0, 0, -1})).rays = k_rays_of_light;
    world.place(square, moved({0, 0, -2})).rays = k_rays_of_sight;
    world.place(square, moved({0, 0, -3})).rays = 0;
    const Tracer tracer{world.scene};
    TraceRay ray{.origin_m = {0.1, 0.2, 0}};
    EXPECT_EQ(tracer.first_hit(ray)->instance, 0u);
    ray.rays = k_rays_of_sight;
    EXPECT_EQ(tracer.first_hit(ray)->instance, 1u);
    ray.t_min = 2.5;
    ray.rays = k_rays_of_all;
    EXPECT_FALSE(tracer.is_stopped(ray));
}

// Aslant layers closer than single precision can tell apart at that distance, against all planes in double.
TEST(Tracer, SurfacesCountInTheirExactOrder) {
    TracedWorld world;
    const std::uint32_t square = world.mesh(facing_square());
    const glm::mat4 aslant = glm::rotate(glm::mat4{1.0f}, 0.6f, {0.3f, 1, 0.2f});
    for (int i = 0; i < 8; ++i) {
        const float gap = 1e-7f * static_cast<float>((i * 5) % 8);
        const glm::mat4 turned = glm::rotate(glm::mat4{1.0f}, 0.7f * static_cast<float>(i), {0, 0, 1});
        world.place(square, aslant * moved({0, 0, gap}) * turned * scaled({50, 50, 1}));
    }
    const Tracer tracer{world.scene};
    const PlacedScene placed{world.scene};
    std::set<std::uint32_t> nearest_of_all;
    for (int i = 0; i < 300; ++i) {
        const TraceRay ray{.origin_m = {7.3 - 0.031 * i, 3.7 + 0.011 * i, 200.0 + 0.37 * i},
                           .direction = {0.01 * (i % 5), 0.013 * (i % 7), -1}};
        std::uint32_t nearest = 0;
        double least = 1e30;
        for (std::uint32_t instance = 0; instance < 8; ++instance) {
            const double t = placed.placed_triangle(instance, 0).meet(ray.origin_m, ray.direction)->t;
            if (t < least) nearest = instance;
            least = std::min(least, t);
        }
        nearest_of_all.insert(nearest);
        const auto hit = tracer.first_hit(ray);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->instance, nearest) << i;
        EXPECT_NEAR(hit->t, least, 1e-11);
    }
    EXPECT_GT(nearest_of_all.size(), 1u) << "they cross each other: floats place them";
}

TEST(Tracer, OfEqualSurfacesTheFirstInstanceIsHit) {
    TracedWorld world;
    const std::uint32_t square = world.mesh(facing_square());
    for (int i = 0; i < 40; ++i)
        world.place(square, moved({0, 0, -2}));
    const Tracer tracer{world.scene};
    EXPECT_EQ(tracer.first_hit({.origin_m = {0.1, 0.2, 0}})->instance, 0u);
}

}  // namespace
}  // namespace rambla::assets::test
