#include <gtest/gtest.h>

#include <cmath>

#include "assets/process/bounds.h"
#include "assets/process/occluders.h"
#include "assets/process/optimise.h"
#include "assets/process/shadow_mesh.h"
#include "assets/process/simplify.h"
#include "assets/process/solid.h"
#include "assets/process/tangents.h"
#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

void scale(Mesh& mesh, float factor) {
    for (glm::vec3& position : mesh.positions)
        position *= factor;
}

void expect_sound(const Mesh& mesh, const LodChain& chain) {
    for (const LodLevel& level : chain.levels) {
        EXPECT_TRUE(std::isfinite(level.error_m) && level.error_m >= 0.0f);
        EXPECT_TRUE(std::isfinite(level.normal_error_deg) && std::isfinite(level.uv_error));
        EXPECT_EQ(level.range.count % 3, 0u);
        EXPECT_LE(level.range.first + level.range.count, chain.indices.size());
    }
    for (const std::uint32_t index : chain.indices)
        EXPECT_LT(index, mesh.positions.size());
}

/// Everything that is done to a mesh.
LodChain processed(Mesh mesh) {
    merge_identical_vertices(mesh);
    LodChain chain = lod_chain(mesh, {}, Borders::free);
    optimise(mesh, chain);
    expect_sound(mesh, chain);
    const ShadowMesh shadow = shadow_mesh(mesh, chain);
    for (const std::uint32_t index : shadow.indices)
        EXPECT_LT(index, shadow.positions.size());
    const OccluderProxy proxy = occluder_proxy(mesh, {.least_size_m = 0.0f});
    EXPECT_TRUE(std::isfinite(proxy.gap_m));
    compute_normals(mesh);
    compute_tangents(mesh);
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        EXPECT_NEAR(glm::length(glm::vec3{mesh.tangents[i]}), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(glm::vec3{mesh.tangents[i]}, mesh.normals[i]), 0.0f, 1e-5f);
    }
    return chain;
}

TEST(MeshProcessing, ErrorsScaleWithTheMesh) {
    // Powers of two change no bit of a mantissa: 2⁻²⁰ ≈ 1e-6 and 2²⁰ ≈ 1e6.
    const Mesh mesh = torus(32, 16);
    LodParameters parameters;
    parameters.sloppy_below_m = 0.0f;
    const LodChain unit = lod_chain(mesh, parameters, Borders::free);
    ASSERT_GE(unit.levels.size(), 3u);
    for (const float factor : {0x1p-20f, 0x1p20f}) {
        Mesh scaled = mesh;
        scale(scaled, factor);
        const LodChain chain = lod_chain(scaled, parameters, Borders::free);
        EXPECT_EQ(chain.indices, unit.indices);
        ASSERT_EQ(chain.levels.size(), unit.levels.size());
        for (std::size_t i = 0; i < chain.levels.size(); ++i) {
            EXPECT_FLOAT_EQ(chain.levels[i].error_m, factor * unit.levels[i].error_m);
            EXPECT_NEAR(chain.levels[i].normal_error_deg, unit.levels[i].normal_error_deg, 1e-3f);
        }
    }
}

TEST(MeshProcessing, FarFromTheOriginErrorsStayTrue) {
    Mesh mesh = torus(32, 16);
    for (glm::vec3& position : mesh.positions)
        position += glm::vec3{1e6f, 0.0f, -1e6f};  // floats are 1/16 m apart there
    const LodChain chain = lod_chain(mesh, {}, Borders::free);
    for (const LodLevel& level : chain.levels) {
        const std::uint32_t* const indices = &chain.indices[level.range.first];
        EXPECT_GE(level.error_m, sampled_deviation(mesh.positions, mesh.indices.data(), mesh.indices.size(),
                                                   indices, level.range.count, 2));
    }
    const BoundingSphere ball = bounding_sphere_of(mesh.positions);
    for (const glm::vec3 position : mesh.positions)
        EXPECT_LE(glm::distance(glm::dvec3{position}, glm::dvec3{ball.centre}), double{ball.radius});
}

TEST(MeshProcessing, OddMeshesAreHandled) {
    Mesh triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.indices = {0, 1, 2};
    EXPECT_TRUE(processed(triangle).levels.empty());

    Mesh point;
    point.positions.assign(300, {5, 5, 5});
    for (std::uint32_t i = 0; i < 300; ++i)
        point.indices.push_back(i);
    EXPECT_TRUE(processed(point).levels.empty());

    Mesh line = flat_grid(20);
    for (glm::vec3& position : line.positions)
        position = {position.x, 0.0f, 0.0f};
    processed(line);

    Mesh thin = flat_grid(40);
    for (glm::vec3& position : thin.positions)
        position.z *= 1e-7f;
    processed(thin);

    Mesh twice = torus(16, 8);
    const std::vector<std::uint32_t> once = twice.indices;
    twice.indices.insert(twice.indices.end(), once.begin(), once.end());
    processed(twice);

    // Many fins on one edge, and a vertex that is a corner of everything.
    Mesh fins;
    fins.positions = {{0, 0, 0}, {0, 1, 0}};
    for (std::uint32_t i = 0; i < 50; ++i) {
        const float angle = 0.1f * static_cast<float>(i);
        fins.positions.emplace_back(std::cos(angle), 0.5f, std::sin(angle));
        fins.indices.insert(fins.indices.end(), {0, 1, 2 + i});
    }
    processed(fins);

    Mesh repeated = flat_grid(8);
    repeated.indices.insert(repeated.indices.end(), {0, 0, 0, 1, 1, 2, 3, 4, 3});
    processed(repeated);

    Mesh huge = torus(16, 8);
    scale(huge, 1e6f);
    EXPECT_FALSE(processed(huge).levels.empty());
    Mesh tiny = torus(16, 8);
    scale(tiny, 1e-6f);
    EXPECT_FALSE(processed(tiny).levels.empty());

    Mesh not_finite = torus(16, 8);
    not_finite.positions[7].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(lod_chain(not_finite, {}, Borders::free).levels.empty());
    EXPECT_TRUE(occluder_proxy(not_finite, {}).boxes.empty());
}

TEST(MeshProcessing, RandomTrianglesAreHandled) {
    std::mt19937 random{23};
    for (int round = 0; round < 20; ++round)
        processed(random_full_mesh(random, 30, 60));
}

TEST(MeshProcessing, FlatSurfacesAreFoundFlat) {
    // Nothing is lost, though no triangle of one level fits one of another: the stated error is the
    // resolution.
    const Mesh mesh = flat_grid(50);
    const LodChain chain = lod_chain(mesh, {.levels = 8, .sloppy_below_m = 0.0f}, Borders::free);
    ASSERT_GE(chain.levels.size(), 4u);
    EXPECT_LT(chain.levels[3].error_m, 2e-5f);
}

TEST(MeshProcessing, TangentsAndNormalsHaveNoScale) {
    for (const float factor : {1e-12f, 1e-6f, 1e6f, 1e12f}) {
        Mesh mesh = flat_grid(4);
        scale(mesh, factor);
        for (glm::vec2& uv : mesh.uv0)
            uv *= 1e-6f;
        mesh.normals.clear();
        compute_normals(mesh);
        compute_tangents(mesh);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_NEAR(mesh.normals[i].y, 1.0f, 1e-6f);
            EXPECT_NEAR(mesh.tangents[i].x, 1.0f, 1e-6f);
        }
    }
}

}  // namespace
}  // namespace rambla::assets::test
