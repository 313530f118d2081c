#include "assets/process/occluders.h"

#include <gtest/gtest.h>

#include "assets/process/solid.h"
#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

/// How often a ray enters the mesh less how often it leaves it, by Möller & Trumbore 1997: a test of its own.
int crossings(const Mesh& mesh, glm::dvec3 origin, glm::dvec3 direction) {
    int sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a{mesh.positions[mesh.indices[i]]};
        const glm::dvec3 e1 = glm::dvec3{mesh.positions[mesh.indices[i + 1]]} - a;
        const glm::dvec3 e2 = glm::dvec3{mesh.positions[mesh.indices[i + 2]]} - a;
        const glm::dvec3 p = glm::cross(direction, e2);
        const double det = glm::dot(e1, p);
        if (det == 0.0) continue;
        const double u = glm::dot(origin - a, p) / det;
        const glm::dvec3 q = glm::cross(origin - a, e1);
        const double v = glm::dot(direction, q) / det;
        if (u < 0.0 || v < 0.0 || u + v > 1.0 || glm::dot(e2, q) / det < 0.0) continue;
        sum += det < 0.0 ? 1 : -1;  // leaving through a triangle seen from behind
    }
    return sum;
}

/// The middle one of three rays' answers: one that hits an edge may be wrong.
bool is_inside(const Mesh& mesh, glm::dvec3 point) {
    int votes = 0;
    for (const glm::dvec3 direction :
         {glm::dvec3{0.31, 0.72, 0.62}, glm::dvec3{-0.83, 0.11, 0.55}, glm::dvec3{0.17, -0.91, 0.38}})
        votes += crossings(mesh, point, direction) > 0 ? 1 : 0;
    return votes >= 2;
}

/// Corners and random points of all boxes.
void expect_inside(const Mesh& mesh, const OccluderProxy& proxy) {
    std::mt19937 random{4};
    std::uniform_real_distribution<double> unit{0.0, 1.0};
    for (const Bounds& box : proxy.boxes) {
        const glm::dvec3 min{box.min};
        const glm::dvec3 size = glm::dvec3{box.max} - min;
        ASSERT_GT(std::min({size.x, size.y, size.z}), 0.0);
        for (int i = 0; i < 8; ++i)
            EXPECT_TRUE(is_inside(mesh, min + size * glm::dvec3{i & 1, (i >> 1) & 1, i >> 2}));
        for (int i = 0; i < 300; ++i) {
            glm::dvec3 at{unit(random), unit(random), unit(random)};
            at[i % 3] = i % 2;  // on a side, where a box would first stick out
            EXPECT_TRUE(is_inside(mesh, min + size * at));
        }
    }
}

TEST(Occluders, ABoxIsFilled) {
    const Mesh mesh = box({-7.3f, 0.1f, 2.0f}, {9.1f, 21.7f, 14.9f});
    const OccluderProxy proxy = occluder_proxy(mesh, {});
    ASSERT_EQ(proxy.boxes.size(), 1u);
    expect_inside(mesh, proxy);
    // Within 1/4096 of a voxel, 0.7 m here, and rounding.
    EXPECT_LT(proxy.gap_m, 0.002f);
    const glm::vec3 size = proxy.boxes[0].max - proxy.boxes[0].min;
    EXPECT_GT(size.x * size.y * size.z, 0.999f * 16.4f * 21.6f * 12.9f);
}

TEST(Occluders, AnAngledHouseTakesTwoBoxesThatOverlap) {
    // An L of one prism: 10 × 10 m without a 6 × 6 m corner, 12 m high.
    Mesh mesh;
    const std::vector<glm::vec2> outline{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};
    for (const float y : {0.0f, 12.0f})
        for (const glm::vec2 p : outline)
            mesh.positions.emplace_back(p.x, y, p.y);
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        mesh.indices.insert(mesh.indices.end(), {i, next + 6, next, i, i + 6, next + 6});
    }
    for (const auto& t :
         {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}, std::array{0u, 3u, 4u}, std::array{0u, 4u, 5u}}) {
        mesh.indices.insert(mesh.indices.end(), {t[0], t[1], t[2]});
        mesh.indices.insert(mesh.indices.end(), {t[0] + 6, t[2] + 6, t[1] + 6});
    }
    ASSERT_TRUE(is_closed(mesh.positions, mesh.indices));
    ASSERT_NEAR(enclosed_volume({mesh.positions, mesh.indices}), 64.0 * 12.0, 1e-9);
    const OccluderProxy proxy = occluder_proxy(mesh, {});
    ASSERT_EQ(proxy.boxes.size(), 2u);
    expect_inside(mesh, proxy);
    EXPECT_GT(proxy.volume_share, 0.998f);
    EXPECT_LE(proxy.volume_share, 1.0f);
    EXPECT_LT(proxy.gap_m, 0.01f);
    const glm::vec3 overlap =
        glm::min(proxy.boxes[0].max, proxy.boxes[1].max) - glm::max(proxy.boxes[0].min, proxy.boxes[1].min);
    EXPECT_GT(std::min({overlap.x, overlap.y, overlap.z}), 1.0f);
}

TEST(Occluders, RoomsInsideAreNoPartOfIt) {
    Mesh mesh = box({0, 0, 0}, {20, 20, 20});
    add_box(mesh, {4, 4, 4}, {16, 16, 16}, true);
    ASSERT_TRUE(is_closed(mesh.positions, mesh.indices));
    const OccluderProxy proxy = occluder_proxy(mesh, {.voxels = 40});
    EXPECT_FALSE(proxy.boxes.empty());
    expect_inside(mesh, proxy);
}

TEST(Occluders, RoundAndWarpedMeshesHoldTheirBoxes) {
    std::mt19937 random{9};
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    for (int round = 0; round < 8; ++round) {
        Mesh mesh = torus(24, 16, 6.0f, 3.0f);
        const float twist = 0.15f * unit(random);
        const glm::vec3 phase{unit(random), unit(random), unit(random)};
        for (glm::vec3& p : mesh.positions) {
            p += 0.6f * glm::sin(p * 0.9f + 3.0f * phase);
            const float c = std::cos(twist * p.y);
            const float s = std::sin(twist * p.y);
            p = {c * p.x - s * p.z, p.y, s * p.x + c * p.z};
        }
        const OccluderProxy proxy = occluder_proxy(mesh, {.boxes = 8, .smallest = 0.01f});
        EXPECT_FALSE(proxy.boxes.empty());
        expect_inside(mesh, proxy);
        EXPECT_GT(proxy.gap_m, 0.1f);
        EXPECT_LT(proxy.volume_share, 0.9f);
    }
}

TEST(Occluders, TheGapIsAnUpperBound) {
    const Mesh mesh = torus(24, 16, 6.0f, 3.0f);
    const OccluderProxy proxy = occluder_proxy(mesh, {});
    ASSERT_FALSE(proxy.boxes.empty());
    double largest = 0.0;
    for (const glm::vec3 p : mesh.positions) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Bounds& box : proxy.boxes)
            nearest = std::min(nearest, double{glm::distance(p, glm::clamp(p, box.min, box.max))});
        largest = std::max(largest, nearest);
    }
    EXPECT_GE(proxy.gap_m, largest);
    EXPECT_LE(proxy.gap_m, 1.1 * largest);
}

TEST(Occluders, MeshesWithoutAnInsideHaveNone) {
    Mesh open = box({0, 0, 0}, {10, 10, 10});
    open.indices.resize(open.indices.size() - 3);
    EXPECT_FALSE(is_closed(open.positions, open.indices));
    EXPECT_TRUE(occluder_proxy(open, {}).boxes.empty());
    Mesh room;
    add_box(room, {0, 0, 0}, {10, 10, 10}, true);
    EXPECT_TRUE(is_closed(room.positions, room.indices));
    EXPECT_TRUE(occluder_proxy(room, {}).boxes.empty());
    EXPECT_TRUE(occluder_proxy(box({0, 0, 0}, {1, 1, 1}), {}).boxes.empty());  // below 2 m
    EXPECT_TRUE(occluder_proxy({}, {}).boxes.empty());
    Mesh sheet;  // closed, but both sides lie on each other
    sheet.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
    sheet.indices = {0, 1, 2, 0, 2, 1};
    EXPECT_TRUE(is_closed(sheet.positions, sheet.indices));
    EXPECT_TRUE(occluder_proxy(sheet, {}).boxes.empty());
}

TEST(Solid, WindingNumbersCountLayers) {
    Mesh mesh = box({0, 0, 0}, {10, 10, 10});
    add_box(mesh, {2, 2, 2}, {8, 8, 8});
    const Surface surface{mesh.positions, mesh.indices};
    EXPECT_NEAR(winding_number(surface, {1, 1, 1}), 1.0, 1e-12);
    EXPECT_NEAR(winding_number(surface, {5, 5, 5}), 2.0, 1e-12);
    EXPECT_NEAR(winding_number(surface, {-1, 5, 5}), 0.0, 1e-12);
}

TEST(Solid, TouchingIsMeasuredAlongAllAxes) {
    const glm::dvec3 min{0.0};
    const glm::dvec3 max{1.0};
    EXPECT_TRUE(touches_box({glm::dvec3{0.5, 0.5, 0.5}, glm::dvec3{9, 9, 9}, glm::dvec3{9, 0, 9}}, min, max));
    EXPECT_TRUE(
        touches_box({glm::dvec3{-9, -9, 0.5}, glm::dvec3{9, -9, 0.5}, glm::dvec3{0, 18, 0.5}}, min, max));
    EXPECT_TRUE(touches_box({glm::dvec3{1, 0, 0}, glm::dvec3{2, 0, 0}, glm::dvec3{2, 1, 0}}, min, max));
    EXPECT_FALSE(touches_box({glm::dvec3{1.01, 0, 0}, glm::dvec3{2, 0, 0}, glm::dvec3{2, 1, 0}}, min, max));
    // Across a corner: only its plane, or only a product of edges, separates.
    EXPECT_FALSE(
        touches_box({glm::dvec3{3.1, 0, 0}, glm::dvec3{0, 3.1, 0}, glm::dvec3{0, 0, 3.1}}, min, max));
    EXPECT_TRUE(touches_box({glm::dvec3{2.9, 0, 0}, glm::dvec3{0, 2.9, 0}, glm::dvec3{0, 0, 2.9}}, min, max));
    EXPECT_FALSE(
        touches_box({glm::dvec3{2.2, 0, 0.1}, glm::dvec3{0, 2.2, 0.9}, glm::dvec3{2.2, 2.2, 0.5}}, min, max));
}

}  // namespace
}  // namespace rambla::assets::test
