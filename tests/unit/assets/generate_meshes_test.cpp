#include <gtest/gtest.h>

#include <cmath>

#include "unit/assets/generate_support.h"

namespace rambla::assets::test {
namespace {

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST(GeneratedMeshes, HaveWholeColumnsAndIndicesInRange) {
    for (const Mesh& mesh : street().scene.meshes) {
        const std::size_t count = mesh.positions.size();
        ASSERT_GT(count, 0u) << mesh.name;
        ASSERT_EQ(mesh.normals.size(), count) << mesh.name;
        ASSERT_EQ(mesh.tangents.size(), count) << mesh.name;
        ASSERT_EQ(mesh.uv0.size(), count) << mesh.name;
        ASSERT_TRUE(mesh.colours.empty() || mesh.colours.size() == count) << mesh.name;
        ASSERT_EQ(mesh.indices.size() % 3, 0u) << mesh.name;
        for (const std::uint32_t index : mesh.indices)
            ASSERT_LT(index, count) << mesh.name;
    }
}

TEST(GeneratedMeshes, HaveFiniteVerticesWithOrthonormalFrames) {
    // Normalising in floats leaves a few units of 2⁻²³ in length and in the dot product; 1e-4 is far above.
    constexpr float k_tolerance = 1e-4f;
    for (const Mesh& mesh : street().scene.meshes) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 tangent{mesh.tangents[i]};
            ASSERT_TRUE(finite(mesh.positions[i])) << mesh.name;
            ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, k_tolerance) << mesh.name;
            ASSERT_NEAR(glm::length(tangent), 1.0f, k_tolerance) << mesh.name;
            ASSERT_NEAR(glm::dot(tangent, mesh.normals[i]), 0.0f, k_tolerance) << mesh.name;
            ASSERT_EQ(std::abs(mesh.tangents[i].w), 1.0f) << mesh.name;
            ASSERT_TRUE(std::isfinite(mesh.uv0[i].x) && std::isfinite(mesh.uv0[i].y)) << mesh.name;
            ASSERT_GE(mesh.positions[i].y, mesh.bounds.min.y) << mesh.name;
            ASSERT_LE(mesh.positions[i].y, mesh.bounds.max.y) << mesh.name;
        }
        for (const glm::vec4& colour : mesh.colours)
            for (int channel = 0; channel < 4; ++channel)
                ASSERT_TRUE(colour[channel] >= 0.0f && colour[channel] <= 1.0f);
    }
}

TEST(GeneratedMeshes, HaveAlmostNoDegenerateTriangles) {
    std::size_t triangles = 0;
    std::size_t degenerate = 0;
    for (const Mesh& mesh : street().scene.meshes) {
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]];
            const glm::vec3 b = mesh.positions[mesh.indices[i + 1]];
            const glm::vec3 c = mesh.positions[mesh.indices[i + 2]];
            ++triangles;
            if (glm::length(glm::cross(b - a, c - a)) < 1e-8f) ++degenerate;
        }
    }
    EXPECT_LT(static_cast<double>(degenerate), 0.001 * static_cast<double>(triangles));
}

TEST(GeneratedMeshes, WindAsTheirNormalsSay) {
    // Leaves are shaded by their crown's shape and seen from both sides: their winding says nothing.
    const Scene& scene = street().scene;
    std::size_t triangles = 0;
    std::size_t against = 0;
    for (const Model& model : scene.models) {
        for (const ModelPart& part : model.parts) {
            if (scene.materials[part.material].double_sided) continue;
            const Mesh& mesh = scene.meshes[part.mesh];
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                const std::uint32_t* index = &mesh.indices[i];
                const glm::vec3 face = glm::cross(mesh.positions[index[1]] - mesh.positions[index[0]],
                                                  mesh.positions[index[2]] - mesh.positions[index[0]]);
                ++triangles;
                if (glm::dot(face, mesh.normals[index[0]] + mesh.normals[index[1]] + mesh.normals[index[2]]) <
                    0.0f)
                    ++against;
            }
        }
    }
    // Tubes that flatten to a tip have a few slivers whose smooth normals lean over.
    EXPECT_LT(static_cast<double>(against), 0.002 * static_cast<double>(triangles));
}

TEST(GeneratedMeshes, HaveTangentsThatFollowTheirTextureCoordinates) {
    // On every triangle of planar surfaces the position must grow along the tangent as u grows, and along the
    // bitangent as v falls: checked against finite differences of the triangle itself.
    const Scene& scene = street().scene;
    std::size_t checked = 0;
    std::size_t wrong = 0;
    for (const Mesh& mesh : scene.meshes) {
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::uint32_t a = mesh.indices[i];
            const std::uint32_t b = mesh.indices[i + 1];
            const std::uint32_t c = mesh.indices[i + 2];
            const glm::vec2 ab = mesh.uv0[b] - mesh.uv0[a];
            const glm::vec2 ac = mesh.uv0[c] - mesh.uv0[a];
            const float area = ab.x * ac.y - ab.y * ac.x;
            if (std::abs(area) < 1e-7f) continue;
            const glm::vec3 p = mesh.positions[b] - mesh.positions[a];
            const glm::vec3 q = mesh.positions[c] - mesh.positions[a];
            const glm::vec3 along_u = (p * ac.y - q * ab.y) / area;
            const glm::vec3 along_v = (q * ab.x - p * ac.x) / area;
            const glm::vec3 bitangent =
                mesh.tangents[a].w * glm::cross(mesh.normals[a], glm::vec3{mesh.tangents[a]});
            ++checked;
            if (glm::dot(along_u, glm::vec3{mesh.tangents[a]}) < 0.0f || glm::dot(along_v, bitangent) > 0.0f)
                ++wrong;
        }
    }
    ASSERT_GT(checked, 10'000u);
    // Leaf cards whose bent normals lean far from the card turn their tangent frame with them.
    EXPECT_LT(static_cast<double>(wrong), 0.05 * static_cast<double>(checked));
}

TEST(GeneratedMeshes, StayWithinTheBudgetOfASoftwareRasteriser) {
    const Scene& scene = street().scene;
    const auto triangles = [&](std::uint32_t model) {
        std::size_t sum = 0;
        for (const ModelPart& part : scene.models[model].parts)
            sum += scene.meshes[part.mesh].indices.size() / 3;
        return sum;
    };
    std::size_t total = 0;
    for (const Shown& shown : shown_models(scene)) {
        const std::size_t count = triangles(shown.model);
        total += count;
        if (shown.root == "house") {
            EXPECT_LT(count, 6000u);
        }
        if (shown.root == "tree") {
            EXPECT_LT(count, 1700u);
        }
    }
    EXPECT_LT(total, 1'100'000u);
    // Panes that are lit warm or blue at night are materials of their own.
    EXPECT_LE(scene.materials.size(), 64u);
}

}  // namespace
}  // namespace rambla::assets::test
