#include "assets/process/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "assets/process/solid.h"
#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

std::span<const std::uint32_t> triangles_of(const LodChain& chain, std::size_t level) {
    return std::span{chain.indices}.subspan(chain.levels[level].range.first, chain.levels[level].range.count);
}

float hills(float x, float z) {
    return 0.1f * std::sin(9.0f * x) * std::cos(7.0f * z);
}

TEST(LodChain, ErrorsAreUpperBoundsAndTight) {
    for (const Mesh& mesh : {grid(20, hills), torus(24, 12)}) {
        const LodChain chain = lod_chain(mesh, {}, Borders::free);
        ASSERT_GE(chain.levels.size(), 3u);
        for (std::size_t i = 0; i < chain.levels.size(); ++i) {
            const auto level = triangles_of(chain, i);
            const double there = sampled_deviation(mesh.positions, mesh.indices.data(), mesh.indices.size(),
                                                   level.data(), level.size(), 4);
            const double back = sampled_deviation(mesh.positions, level.data(), level.size(),
                                                  mesh.indices.data(), mesh.indices.size(), 12);
            const double sampled = std::max(there, back);
            EXPECT_GE(chain.levels[i].error_m, sampled) << "level " << i;
            // The bounds are refined to 2 %, the rest is what samples miss; errors that must not fall along
            // the chain are compared with the largest so far.
            if (i == 0 || chain.levels[i].error_m > chain.levels[i - 1].error_m) {
                EXPECT_LE(chain.levels[i].error_m, 1.10 * sampled) << "level " << i;
            }
        }
    }
}

TEST(LodChain, EachLevelHasFewerTrianglesAndNoLessError) {
    const Mesh mesh = torus(64, 32);
    const LodParameters parameters{.levels = 5};
    const LodChain chain = lod_chain(mesh, parameters, Borders::free);
    ASSERT_EQ(chain.levels.size(), 5u);
    std::size_t indices = mesh.indices.size();
    std::uint32_t end = 0;
    float error_m = 0.0f;
    for (const LodLevel& level : chain.levels) {
        EXPECT_EQ(level.range.first, end);
        EXPECT_LE(level.range.count, parameters.pays * static_cast<double>(indices));
        EXPECT_GE(level.error_m, error_m);
        EXPECT_LE(level.error_m, parameters.max_error * 2.8f);
        indices = level.range.count;
        end += level.range.count;
        error_m = level.error_m;
    }
    EXPECT_EQ(chain.indices.size(), end);
}

TEST(LodChain, EndsBeforeTheErrorIsExceeded) {
    const Mesh mesh = grid(48, hills);
    const LodChain generous = lod_chain(mesh, {.max_error = 0.1f}, Borders::free);
    const LodChain strict = lod_chain(mesh, {.max_error = 0.005f}, Borders::free);
    EXPECT_LT(strict.levels.size(), generous.levels.size());
    ASSERT_FALSE(strict.levels.empty());
    EXPECT_LE(strict.levels.back().error_m, 0.005f);
}

TEST(LodChain, LockedBordersStayWhole) {
    const Mesh mesh = grid(32, hills);
    const auto border_edges = [](std::span<const std::uint32_t> triangles) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const std::uint32_t a = triangles[i];
            const std::uint32_t b = triangles[i % 3 == 2 ? i - 2 : i + 1];
            if (edges.erase({b, a}) == 0) edges.insert({a, b});
        }
        return edges;
    };
    const auto whole = border_edges(mesh.indices);
    ASSERT_EQ(whole.size(), 128u);
    const LodChain locked = lod_chain(mesh, {.max_error = 0.02f}, Borders::locked);
    ASSERT_GE(locked.levels.size(), 2u);
    for (std::size_t i = 0; i < locked.levels.size(); ++i)
        EXPECT_EQ(border_edges(triangles_of(locked, i)), whole);
    const LodChain free = lod_chain(mesh, {.max_error = 0.02f}, Borders::free);
    EXPECT_LT(border_edges(triangles_of(free, free.levels.size() - 1)).size(), 64u);
}

TEST(LodChain, SeamsOpenNoCracks) {
    const Mesh mesh = torus(48, 24);
    ASSERT_TRUE(is_closed(mesh.positions, mesh.indices));
    const LodChain chain = lod_chain(mesh, {.sloppy_below_m = 0.0f}, Borders::free);
    ASSERT_GE(chain.levels.size(), 3u);
    for (std::size_t i = 0; i < chain.levels.size(); ++i) {
        EXPECT_TRUE(is_closed(mesh.positions, triangles_of(chain, i)));
        // A triangle that crossed a seam would run through the whole picture.
        for (std::size_t t = 0; t < triangles_of(chain, i).size(); t += 3) {
            const std::uint32_t* const c = &triangles_of(chain, i)[t];
            const glm::vec2 low = glm::min(glm::min(mesh.uv0[c[0]], mesh.uv0[c[1]]), mesh.uv0[c[2]]);
            const glm::vec2 high = glm::max(glm::max(mesh.uv0[c[0]], mesh.uv0[c[1]]), mesh.uv0[c[2]]);
            EXPECT_LT(high.x - low.x, 0.6f);
            EXPECT_LT(high.y - low.y, 0.8f);
        }
    }
}

TEST(LodChain, AttributeErrorsAreStated) {
    Mesh flat = flat_grid(32);
    const LodChain exact = lod_chain(flat, {.sloppy_below_m = 0.0f}, Borders::free);
    ASSERT_FALSE(exact.levels.empty());
    EXPECT_LT(exact.levels.back().error_m, 2e-5f);
    EXPECT_LT(exact.levels.back().uv_error, 1e-5f);
    EXPECT_LT(exact.levels.back().normal_error_deg, 1e-3f);
    for (std::size_t i = 0; i < flat.positions.size(); ++i)
        flat.uv0[i].x = flat.positions[i].x * flat.positions[i].x;
    const LodChain bent = lod_chain(flat, {.sloppy_below_m = 0.0f}, Borders::free);
    EXPECT_GT(bent.levels.back().uv_error, 0.003f);
    const LodChain round = lod_chain(torus(48, 24), {}, Borders::free);
    EXPECT_GT(round.levels.back().normal_error_deg, 1.0f);
    EXPECT_GT(round.levels.back().normal_error_deg, round.levels.front().normal_error_deg);
}

/// Every triangle has vertices of its own normal: edge collapse finds nothing that it may move.
Mesh faceted_torus() {
    const Mesh smooth = torus(24, 12);
    Mesh mesh;
    for (std::size_t i = 0; i < smooth.indices.size(); i += 3) {
        const glm::vec3* const p = smooth.positions.data();
        const glm::vec3 normal = glm::normalize(glm::cross(p[smooth.indices[i + 1]] - p[smooth.indices[i]],
                                                           p[smooth.indices[i + 2]] - p[smooth.indices[i]]));
        for (std::size_t c = 0; c < 3; ++c) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(p[smooth.indices[i + c]]);
            mesh.normals.push_back(normal);
        }
    }
    return mesh;
}

TEST(LodChain, OnlySmallMeshesAreSimplifiedWithoutRegardToSeams) {
    const Mesh mesh = faceted_torus();  // 2.8 m wide
    EXPECT_TRUE(lod_chain(mesh, {.sloppy_below_m = 2.0f}, Borders::free).levels.empty());
    EXPECT_TRUE(lod_chain(mesh, {.sloppy_below_m = 3.0f}, Borders::locked).levels.empty());
    const LodChain chain = lod_chain(mesh, {.sloppy_below_m = 3.0f}, Borders::free);
    ASSERT_FALSE(chain.levels.empty());
    for (std::size_t i = 0; i < chain.levels.size(); ++i) {
        const auto level = triangles_of(chain, i);
        EXPECT_TRUE(chain.levels[i].sloppy);
        EXPECT_GE(chain.levels[i].error_m,
                  sampled_deviation(mesh.positions, mesh.indices.data(), mesh.indices.size(), level.data(),
                                    level.size(), 4));
        EXPECT_LE(chain.levels[i].error_m, 0.28f);
    }
}

TEST(LodChain, SkinnedMeshesKeepTheirSeams) {
    Mesh mesh = faceted_torus();
    mesh.joints.assign(mesh.positions.size(), {0, 0, 0, 0});
    mesh.weights.assign(mesh.positions.size(), {1, 0, 0, 0});
    EXPECT_TRUE(lod_chain(mesh, {}, Borders::free).levels.empty());
    Mesh smooth = torus(32, 16);
    smooth.joints.assign(smooth.positions.size(), {0, 0, 0, 0});
    smooth.weights.assign(smooth.positions.size(), {1, 0, 0, 0});
    EXPECT_FALSE(lod_chain(smooth, {}, Borders::free).levels.empty());
}

TEST(LodChain, LevelsThatDoNotPayAreLeftOut) {
    EXPECT_TRUE(lod_chain(box({0, 0, 0}, {9, 9, 9}), {}, Borders::free).levels.empty());
    Mesh points = flat_grid(8);
    points.topology = Topology::points;
    EXPECT_TRUE(lod_chain(points, {}, Borders::free).levels.empty());
    EXPECT_TRUE(lod_chain({}, {}, Borders::free).levels.empty());
    EXPECT_TRUE(lod_chain(flat_grid(8), {.levels = 0}, Borders::free).levels.empty());
}

}  // namespace
}  // namespace rambla::assets::test
