#include "assets/process/tangents.h"

#include <gtest/gtest.h>

#include <random>

#include "assets/mesh_columns.h"
#include "assets/process/columns.h"
#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

// All arithmetic is float on unit-sized data.
constexpr float k_rounding = 1e-5f;

/// A unit square in the xy plane that faces +Z, its picture upright: u to the right, v down.
Mesh upright_square() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

void expect_orthonormal(const Mesh& mesh) {
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        const glm::vec3 tangent{mesh.tangents[i]};
        EXPECT_NEAR(glm::length(tangent), 1.0f, k_rounding);
        EXPECT_NEAR(glm::dot(tangent, mesh.normals[i]), 0.0f, k_rounding);
        EXPECT_EQ(std::abs(mesh.tangents[i].w), 1.0f);
    }
}

TEST(Tangents, UprightPictureHasItsBitangentUp) {
    Mesh mesh = upright_square();
    compute_tangents(mesh);
    for (const glm::vec4& tangent : mesh.tangents)
        EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
}

TEST(Tangents, MirroredPictureFlipsTheSign) {
    Mesh mesh = upright_square();
    for (glm::vec2& uv : mesh.uv0)
        uv.x = 1.0f - uv.x;
    compute_tangents(mesh);
    for (const glm::vec4& tangent : mesh.tangents)
        EXPECT_EQ(tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(Tangents, VertexSharedByMirroredHalvesIsSplit) {
    Mesh mesh = upright_square();
    // A second square to the right whose picture runs back: it shares vertices 1 and 2.
    mesh.positions.insert(mesh.positions.end(), {{2, 0, 0}, {2, 1, 0}});
    mesh.normals.assign(6, {0, 0, 1});
    mesh.uv0.insert(mesh.uv0.end(), {{0, 1}, {0, 0}});
    mesh.indices.insert(mesh.indices.end(), {1, 4, 5, 1, 5, 2});
    compute_tangents(mesh);
    ASSERT_EQ(mesh.positions.size(), 8u);
    expect_orthonormal(mesh);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(mesh.tangents[mesh.indices[i]], glm::vec4(1, 0, 0, 1));
    for (std::size_t i = 6; i < 12; ++i)
        EXPECT_EQ(mesh.tangents[mesh.indices[i]], glm::vec4(-1, 0, 0, -1));
    for (std::size_t i = 6; i < 12; ++i)
        EXPECT_GE(mesh.positions[mesh.indices[i]].x, 1.0f);
}

TEST(Tangents, SplittingMovesAllColumns) {
    std::mt19937 random{12};
    Mesh mesh = random_full_mesh(random, 30, 40);
    const Mesh before = mesh;
    compute_tangents(mesh);
    ASSERT_GT(mesh.positions.size(), before.positions.size());
    for (MorphTarget& morph : mesh.morphs)
        ASSERT_EQ(morph.normals.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t now = mesh.indices[i];
        const std::uint32_t then = before.indices[i];
        EXPECT_EQ(mesh.uv1[now], before.uv1[then]);
        EXPECT_EQ(mesh.joints[now], before.joints[then]);
        EXPECT_EQ(mesh.weights[now], before.weights[then]);
        for (std::size_t m = 0; m < mesh.morphs.size(); ++m) {
            EXPECT_EQ(mesh.morphs[m].positions[now], before.morphs[m].positions[then]);
            EXPECT_EQ(mesh.morphs[m].normals[now], before.morphs[m].normals[then]);
        }
    }
}

TEST(Tangents, DoNotDependOnWhetherVerticesAreShared) {
    // A bent strip whose picture is sheared differently on its two sides.
    Mesh shared;
    shared.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}, {0, 1, 0}, {2, 0.2f, 0}};
    shared.uv0 = {{0, 1}, {1, 1}, {1.3f, 0}, {0, 0}, {2, 0.6f}};
    shared.indices = {0, 1, 2, 0, 2, 3, 1, 4, 2};
    compute_normals(shared);
    Mesh apart = shared;
    for_each_column(apart, [&](auto& column) { column = gathered(column, shared.indices); });
    for (std::uint32_t i = 0; i < 9; ++i)
        apart.indices[i] = i;
    compute_tangents(shared);
    compute_tangents(apart);
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_NEAR(glm::distance(apart.tangents[i], shared.tangents[shared.indices[i]]), 0.0f, k_rounding);
}

TEST(Tangents, FacesWeighByTheirAngleSeenAlongTheNormal) {
    // Two steep faces at the origin, whose normal is +Z: each has one edge along +Y and one that rises or
    // falls.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, -1, 30}, {0, 1, 0}, {-1, -2, 20}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uv0 = {{0, 0}, {1, 0}, {0, -1}, {-1, 2}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    compute_tangents(mesh);
    // With p = u · T + v · B: the first one's T is its rising edge, seen from above 135° from +Y. The second
    // one's B is −Y and (−1, −2, 20) = −T + 2B, so T = (1, 0, −20); its edges are seen 180° − atan(1/2)
    // apart.
    const glm::vec3 first = glm::radians(135.0f) * glm::normalize(glm::vec3{1, -1, 0});
    const glm::vec3 second = (glm::radians(180.0f) - std::atan(0.5f)) * glm::vec3{1, 0, 0};
    EXPECT_NEAR(glm::distance(glm::vec3{mesh.tangents[0]}, glm::normalize(first + second)), 0.0f, k_rounding);
}

TEST(Tangents, DegenerateCoordinatesStillGiveAFrame) {
    Mesh without = upright_square();
    without.uv0.clear();
    compute_tangents(without);
    expect_orthonormal(without);
    Mesh collapsed = upright_square();
    collapsed.uv0.assign(4, {0.5f, 0.5f});
    compute_tangents(collapsed);
    expect_orthonormal(collapsed);
    Mesh point = upright_square();
    point.positions.assign(4, {1, 2, 3});
    compute_tangents(point);
    expect_orthonormal(point);
}

TEST(Tangents, SecondSetOfCoordinatesIsUsedWhenAsked) {
    Mesh mesh = upright_square();
    mesh.uv1 = {{1, 1}, {1, 0}, {0, 0}, {0, 1}};  // the picture turned by a quarter: u runs down, −Y
    compute_tangents(mesh, 1);
    for (const glm::vec4& tangent : mesh.tangents)
        EXPECT_EQ(tangent, glm::vec4(0, -1, 0, 1));
}

TEST(Tangents, RandomMeshesGiveOrthonormalFramesAlongU) {
    std::mt19937 random{11};
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    for (int round = 0; round < 200; ++round) {
        Mesh mesh;
        for (int i = 0; i < 3; ++i) {
            mesh.positions.emplace_back(unit(random), unit(random), unit(random));
            mesh.uv0.emplace_back(unit(random), unit(random));
        }
        mesh.indices = {0, 1, 2};
        compute_normals(mesh);
        compute_tangents(mesh);
        expect_orthonormal(mesh);
        // Independent of the formula: moving along the tangent raises u and, along w · (n × t), never raises
        // v.
        const glm::mat2x3 edges{mesh.positions[1] - mesh.positions[0], mesh.positions[2] - mesh.positions[0]};
        const glm::mat2 uv_edges{mesh.uv0[1] - mesh.uv0[0], mesh.uv0[2] - mesh.uv0[0]};
        const glm::mat2 metric = glm::transpose(edges) * edges;
        if (std::abs(glm::determinant(metric)) < 1e-3f || std::abs(glm::determinant(uv_edges)) < 1e-2f)
            continue;
        const auto uv_along = [&](glm::vec3 d) {
            return uv_edges * (glm::inverse(metric) * (glm::transpose(edges) * d));
        };
        const glm::vec3 tangent{mesh.tangents[0]};
        EXPECT_GT(uv_along(tangent).x, 0.0f);
        EXPECT_NEAR(uv_along(tangent).y / uv_along(tangent).x, 0.0f,
                    1e-2f);  // ill-conditioned triangles round more
        EXPECT_LT(uv_along(mesh.tangents[0].w * glm::cross(mesh.normals[0], tangent)).y, 0.0f);
    }
}

TEST(Normals, SmoothOnesAreWeightedByArea) {
    Mesh mesh;
    // Two triangles meet at the origin: one in xz of area 2, one in xy of area 1/2.
    mesh.positions = {{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {9, 9, 9}};
    mesh.indices = {0, 1, 2, 0, 3, 4};
    compute_normals(mesh);
    const glm::vec3 expected = glm::normalize(glm::vec3{0, 4, 1});
    EXPECT_NEAR(glm::distance(mesh.normals[0], expected), 0.0f, k_rounding);
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[5], glm::vec3(0, 1, 0));  // nothing uses it
}

TEST(Normals, FlatOnesSplitEveryTriangle) {
    Mesh mesh = upright_square();
    mesh.normals.clear();
    mesh.positions[3] = {0, 0, -1};
    compute_flat_normals(mesh);
    ASSERT_EQ(mesh.positions.size(), 6u);
    ASSERT_EQ(mesh.uv0.size(), 6u);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    const glm::vec3 expected = glm::normalize(glm::cross(glm::vec3{1, 1, 0}, glm::vec3{0, 0, -1}));
    EXPECT_NEAR(glm::distance(mesh.normals[5], expected), 0.0f, k_rounding);
}

TEST(Normals, FlatOnesSplitAllColumns) {
    std::mt19937 random{13};
    Mesh mesh = random_full_mesh(random, 10, 20);
    const Mesh before = mesh;
    compute_flat_normals(mesh);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        EXPECT_EQ(mesh.joints[i], before.joints[before.indices[i]]);
        EXPECT_EQ(mesh.morphs[1].positions[i], before.morphs[1].positions[before.indices[i]]);
    }
    EXPECT_TRUE(mesh.tangents.empty());
}

TEST(Normals, PerpendicularIsPerpendicularEverywhere) {
    std::mt19937 random{3};
    std::normal_distribution<float> normal;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 n = glm::normalize(glm::vec3{normal(random), normal(random), normal(random)});
        EXPECT_NEAR(glm::dot(any_perpendicular(n), n), 0.0f, k_rounding);
    }
    for (const glm::vec3 n : {glm::vec3{0, 0, 1}, glm::vec3{0, 0, -1}, glm::vec3{0, 1, 0}})
        EXPECT_NEAR(glm::length(any_perpendicular(n)), 1.0f, k_rounding);
}

}  // namespace
}  // namespace rambla::assets::test
