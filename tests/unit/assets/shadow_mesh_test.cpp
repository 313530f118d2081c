#include "assets/process/shadow_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "assets/process/bounds.h"
#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

using Place = std::array<float, 3>;

/// Triangles by the places of their corners, winding kept, in a certain order.
std::vector<std::array<Place, 3>> places(const std::vector<glm::vec3>& positions,
                                         std::span<const std::uint32_t> indices) {
    std::vector<std::array<Place, 3>> all;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        std::array<Place, 3> triangle;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3 p = positions[indices[i + c]];
            triangle[c] = {p.x, p.y, p.z};
        }
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        all.push_back(triangle);
    }
    std::sort(all.begin(), all.end());
    return all;
}

TEST(ShadowMesh, SeamsOfShadingAreWelded) {
    const Mesh mesh = box({-1, -1, -1}, {1, 2, 3});
    const ShadowMesh shadow = shadow_mesh(mesh, {});
    EXPECT_EQ(shadow.positions.size(), 8u);
    ASSERT_EQ(shadow.levels.size(), 1u);
    EXPECT_EQ(shadow.levels[0].count, 36u);
    EXPECT_EQ(places(shadow.positions, shadow.indices), places(mesh.positions, mesh.indices));
}

TEST(ShadowMesh, EveryLevelHasItsShadow) {
    const Mesh mesh = torus(24, 12);
    LodChain chain;
    chain.indices.assign(mesh.indices.begin() + 30, mesh.indices.begin() + 90);
    chain.levels = {{.range = {0, 45}}, {.range = {45, 15}}};
    const ShadowMesh shadow = shadow_mesh(mesh, chain);
    EXPECT_EQ(shadow.positions.size(), 24u * 12u);
    ASSERT_EQ(shadow.levels.size(), 3u);
    for (std::size_t i = 0; i < 2; ++i) {
        const IndexRange here = shadow.levels[i + 1];
        const IndexRange there = chain.levels[i].range;
        EXPECT_EQ(places(shadow.positions, std::span{shadow.indices}.subspan(here.first, here.count)),
                  places(mesh.positions, std::span{chain.indices}.subspan(there.first, there.count)));
    }
}

TEST(ShadowMesh, VerticesThatMoveDifferentlyStayApart) {
    Mesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.joints.assign(24, {0, 0, 0, 0});
    mesh.weights.assign(24, {1, 0, 0, 0});
    mesh.morphs.resize(1);
    mesh.morphs[0].positions.assign(24, {0, 0, 0});
    EXPECT_EQ(shadow_mesh(mesh, {}).positions.size(), 8u);
    Mesh jointed = mesh;
    jointed.joints[0].x = 1;
    EXPECT_EQ(shadow_mesh(jointed, {}).positions.size(), 9u);
    EXPECT_EQ(shadow_mesh(jointed, {}).joints.size(), 9u);
    Mesh morphed = mesh;
    morphed.morphs[0].positions[0].x = 1;
    const ShadowMesh shadow = shadow_mesh(morphed, {});
    EXPECT_EQ(shadow.positions.size(), 9u);
    ASSERT_EQ(shadow.morph_positions.size(), 1u);
    EXPECT_EQ(
        std::count(shadow.morph_positions[0].begin(), shadow.morph_positions[0].end(), glm::vec3(1, 0, 0)),
        1);
}

TEST(ShadowMesh, ZerosOfBothSignsAreOnePlaceAndDegenerateTrianglesAreGone) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 0}, {0, -1, 0}};
    mesh.indices = {0, 1, 2, 3, 4, 1, 0, 3, 1};
    const ShadowMesh shadow = shadow_mesh(mesh, {});
    EXPECT_EQ(shadow.positions.size(), 4u);
    EXPECT_EQ(shadow.indices.size(), 6u);
}

TEST(BoundingSphere, HoldsAllPointsAndIsHardlyLargerThanNeeded) {
    std::mt19937 random{2};
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    for (int round = 0; round < 200; ++round) {
        const glm::vec3 far = 1000.0f * glm::vec3{unit(random), unit(random), unit(random)};
        const float radius = std::exp2(10.0f * unit(random));
        std::vector<glm::vec3> points;
        // Opposite points on a sphere: the smallest ball is the sphere itself.
        for (int i = 0; i < 10; ++i) {
            const glm::vec3 out =
                radius * glm::normalize(glm::vec3{unit(random), unit(random), unit(random)});
            points.push_back(far + out);
            points.push_back(far - out);
        }
        const BoundingSphere ball = bounding_sphere_of(points);
        for (const glm::vec3 point : points)
            EXPECT_LE(glm::distance(glm::dvec3{point}, glm::dvec3{ball.centre}), double{ball.radius});
        EXPECT_LE(ball.radius, 1.05f * radius + 1e-3f);
    }
}

TEST(BoundingSphere, SmallCases) {
    EXPECT_LT(bounding_sphere_of({}).radius, 0.0f);
    const std::vector<glm::vec3> one{{1, 2, 3}};
    EXPECT_EQ(bounding_sphere_of(one).centre, one[0]);
    EXPECT_LT(bounding_sphere_of(one).radius, 1e-6f);
    const std::vector<glm::vec3> two{{0, 0, 0}, {2, 0, 0}};
    EXPECT_EQ(bounding_sphere_of(two).centre, glm::vec3(1, 0, 0));
    EXPECT_NEAR(bounding_sphere_of(two).radius, 1.0f, 1e-6f);
    // An equilateral triangle: neither the box's ball nor two points' is the smallest, radius 1.
    const std::vector<glm::vec3> three{{1, 0, 0}, {-0.5f, 0.8660254f, 0}, {-0.5f, -0.8660254f, 0}};
    EXPECT_NEAR(bounding_sphere_of(three).radius, 1.0f, 0.02f);
    EXPECT_TRUE(bounds_of({}).empty());
    EXPECT_EQ(bounds_of(three).max.x, 1.0f);
}

}  // namespace
}  // namespace rambla::assets::test
