#include "assets/process/deviation.h"

#include <gtest/gtest.h>

#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

// Doubles on unit-sized data.
constexpr double k_rounding = 1e-12;

TEST(Deviation, ParallelSquaresAreTheirDistanceApart) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                           {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}};
    const std::vector<std::uint32_t> lower{0, 1, 2, 0, 2, 3};
    const std::vector<std::uint32_t> upper{4, 5, 7, 5, 6, 7};  // the other diagonal
    const Deviation found = deviation({positions, lower}, {positions, upper}, 1e-6);
    EXPECT_NEAR(found.at_least_m, 2.0, 1e-12);
    EXPECT_NEAR(found.at_most_m, 2.0, 0.05);  // refined to 2 %
    EXPECT_GE(found.at_most_m, 2.0);
}

TEST(Deviation, TheDeepestPointMayLieInsideOfATriangle) {
    // A flat triangle over a pit whose bottom is below its middle: the corners coincide.
    const std::vector<glm::vec3> positions{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, -0.5f}};
    const std::vector<std::uint32_t> lid{0, 1, 2};
    const std::vector<std::uint32_t> pit{0, 1, 3, 1, 2, 3, 2, 0, 3};
    const Deviation down = one_sided_deviation({positions, lid}, {positions, pit}, 1e-6);
    const double sampled = sampled_deviation(positions, lid.data(), 3, pit.data(), 9, 300);
    EXPECT_GT(sampled, 0.3);
    EXPECT_GE(down.at_most_m, sampled);
    EXPECT_NEAR(down.at_most_m, sampled, 0.025 * sampled);
    EXPECT_NEAR(one_sided_deviation({positions, pit}, {positions, lid}, 1e-6).at_least_m, 0.5, 1e-12);
}

TEST(Deviation, DependsOnTheDirection) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 5, 0}};
    const std::vector<std::uint32_t> small{0, 1, 2};
    const std::vector<std::uint32_t> large{0, 1, 3};
    EXPECT_LT(one_sided_deviation({positions, small}, {positions, large}, 1e-6).at_most_m, 1e-5);
    EXPECT_NEAR(one_sided_deviation({positions, large}, {positions, small}, 1e-6).at_least_m, 4.0, 1e-12);
}

TEST(Deviation, BoundsHoldForRandomTriangles) {
    std::mt19937 random{17};
    for (int round = 0; round < 60; ++round) {
        const Mesh mesh = random_full_mesh(random, 40, 24);
        const std::span<const std::uint32_t> all{mesh.indices};
        const auto a = all.first(36);
        const auto b = all.subspan(36);
        const Deviation found = one_sided_deviation({mesh.positions, a}, {mesh.positions, b}, 1e-6);
        constexpr int k_rows = 60;
        const double sampled =
            sampled_deviation(mesh.positions, a.data(), a.size(), b.data(), b.size(), k_rows);
        EXPECT_GE(found.at_most_m + k_rounding, sampled);
        EXPECT_LE(found.at_least_m, found.at_most_m);
        // Between two samples lies at most an edge's 60th part, edges being shorter than the cube's diagonal.
        EXPECT_LE(found.at_least_m, sampled + std::sqrt(12.0) / k_rows);
        EXPECT_LE(found.at_most_m, 1.02 * found.at_least_m + 1e-6);
    }
}

TEST(Deviation, EmptySurfaces) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<std::uint32_t> triangle{0, 1, 2};
    EXPECT_EQ(one_sided_deviation({positions, {}}, {positions, triangle}, 1e-6).at_most_m, 0.0);
    EXPECT_TRUE(std::isinf(one_sided_deviation({positions, triangle}, {positions, {}}, 1e-6).at_least_m));
}

TEST(AttributeDeviation, IsWhatInterpolationMisses) {
    // u = x² over the unit square against u = x between its corners: the root mean square of x − x² is
    // √(1/30). Normals that tilt by 40 x² degrees against 40 x: 40° · √(1/30), small-angle interpolation
    // aside.
    Mesh mesh = flat_grid(64);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float x = mesh.positions[i].x;
        mesh.uv0[i] = {x * x, 0.0f};
        const float tilt = glm::radians(40.0f * x * x);
        mesh.normals[i] = {std::sin(tilt), std::cos(tilt), 0.0f};
    }
    const std::vector<std::uint32_t> corners{0, 64 * 65, 64, 64, 64 * 65, 65 * 65 - 1};
    const AttributeDeviation found = attribute_deviation(mesh, {mesh.positions, corners});
    EXPECT_NEAR(found.uv, std::sqrt(1.0 / 30.0), 0.001);
    EXPECT_NEAR(found.normal_deg, 40.0 * std::sqrt(1.0 / 30.0), 0.1);
    EXPECT_NEAR(attribute_deviation(mesh, {mesh.positions, mesh.indices}).uv, 0.0, 1e-6);
}

}  // namespace
}  // namespace rambla::assets::test
