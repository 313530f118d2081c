#include "assets/process/optimise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "assets/mesh_columns.h"
#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

/// What a triangle shows: the values of all columns at its corners, from the corner that sorts first.
using Shown = std::vector<float>;

std::vector<Shown> shown_triangles(const Mesh& mesh, std::span<const std::uint32_t> indices) {
    std::vector<Shown> all;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        std::array<Shown, 3> corners;
        for (std::size_t c = 0; c < 3; ++c)
            for_each_column(mesh, [&](const auto& column) {
                const auto value = column[indices[i + c]];
                for (int n = 0; n < value.length(); ++n)
                    corners[c].push_back(static_cast<float>(value[n]));
            });
        const auto first = std::min_element(corners.begin(), corners.end());
        std::rotate(corners.begin(), first, corners.end());
        Shown shown;
        for (const Shown& corner : corners)
            shown.insert(shown.end(), corner.begin(), corner.end());
        all.push_back(std::move(shown));
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Vertices transformed per triangle by a cache that holds the last 16.
double cache_misses(std::span<const std::uint32_t> indices) {
    std::deque<std::uint32_t> cache;
    std::size_t misses = 0;
    for (const std::uint32_t index : indices) {
        if (std::find(cache.begin(), cache.end(), index) != cache.end()) continue;
        ++misses;
        cache.push_back(index);
        if (cache.size() > 16) cache.pop_front();
    }
    return static_cast<double>(misses) / (static_cast<double>(indices.size()) / 3.0);
}

void shuffle_triangles(Mesh& mesh, std::mt19937& random) {
    std::vector<std::array<std::uint32_t, 3>> triangles(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        std::copy_n(&mesh.indices[3 * i], 3, triangles[i].begin());
    std::shuffle(triangles.begin(), triangles.end(), random);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        std::copy_n(triangles[i].begin(), 3, &mesh.indices[3 * i]);
}

TEST(Optimise, ThePictureIsTheSameInAllColumns) {
    std::mt19937 random{5};
    for (int round = 0; round < 20; ++round) {
        Mesh mesh = random_full_mesh(random, 60, 100);
        LodChain chain;
        chain.indices.assign(mesh.indices.begin(), mesh.indices.begin() + 90);
        chain.levels = {{.range = {0, 60}}, {.range = {60, 30}}};
        const Mesh before = mesh;
        const LodChain chain_before = chain;
        merge_identical_vertices(mesh);
        optimise(mesh, chain);
        EXPECT_EQ(shown_triangles(mesh, mesh.indices), shown_triangles(before, before.indices));
        for (const LodLevel& level : chain.levels)
            EXPECT_EQ(
                shown_triangles(mesh, std::span{chain.indices}.subspan(level.range.first, level.range.count)),
                shown_triangles(
                    before, std::span{chain_before.indices}.subspan(level.range.first, level.range.count)));
    }
}

TEST(Optimise, OnlyVerticesThatAreEqualInAllColumnsBecomeOne) {
    std::mt19937 random{6};
    Mesh mesh = random_full_mesh(random, 1, 0);
    const auto repeat = [&] {
        for_each_column(mesh, [](auto& column) { column.resize(column.size() + 1, column.front()); });
    };
    std::size_t columns = 0;
    for_each_column(mesh, [&](auto&) { ++columns; });
    ASSERT_EQ(columns, 14u);
    repeat();
    // Then one vertex for each column that differs there alone.
    for (std::size_t changed = 0; changed < columns; ++changed) {
        repeat();
        std::size_t column_number = 0;
        for_each_column(mesh, [&](auto& column) {
            if (column_number++ == changed) column.back()[0] = 77;
        });
    }
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        mesh.indices.push_back(i);
    mesh.topology = Topology::points;
    merge_identical_vertices(mesh);
    EXPECT_EQ(mesh.indices[1], 0u);
    for (std::uint32_t i = 2; i < mesh.indices.size(); ++i)
        EXPECT_EQ(mesh.indices[i], i);
    LodChain chain;
    optimise(mesh, chain);
    EXPECT_EQ(mesh.positions.size(), 1 + columns);
    for_each_column(mesh, [&](const auto& column) { EXPECT_EQ(column.size(), 1 + columns); });
}

TEST(Optimise, TheVertexCacheMissesLess) {
    std::mt19937 random{7};
    Mesh mesh = flat_grid(64);
    shuffle_triangles(mesh, random);
    const double before = cache_misses(mesh.indices);
    LodChain chain;
    optimise(mesh, chain);
    EXPECT_GT(before, 2.5);
    EXPECT_LT(cache_misses(mesh.indices), 0.8);  // 0.5 is the least that any order of a large grid can do
}

TEST(Optimise, TrianglesInFrontComeFirstWhereThatCostsTheCacheLittle) {
    // Shells one inside the other, innermost first: from outside all but the last would be drawn over.
    Mesh mesh;
    for (int shell = 1; shell <= 6; ++shell) {
        const Mesh part = torus(24, 12, 1.0f, 0.1f * static_cast<float>(shell));
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
        for (const std::uint32_t index : part.indices)
            mesh.indices.push_back(first + index);
    }
    const std::uint32_t per_shell = static_cast<std::uint32_t>(mesh.positions.size()) / 6;
    order_triangles(mesh.indices, mesh.positions);
    double outer_place = 0.0;
    double inner_place = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] >= 5 * per_shell) outer_place += static_cast<double>(i);
        if (mesh.indices[i] < per_shell) inner_place += static_cast<double>(i);
    }
    EXPECT_LT(outer_place, 0.5 * inner_place);
}

TEST(Optimise, VerticesLieInTheOrderOfTheirFirstUseAndUnusedOnesAreGone) {
    std::mt19937 random{8};
    Mesh mesh = random_full_mesh(random, 1000, 200);
    LodChain chain;
    optimise(mesh, chain);
    std::uint32_t next = 0;
    for (const std::uint32_t index : mesh.indices) {
        ASSERT_LE(index, next);
        next = std::max(next, index + 1);
    }
    EXPECT_EQ(mesh.positions.size(), next);
    EXPECT_LE(mesh.positions.size(), 600u);
}

TEST(Optimise, LinesKeepTheirOrder) {
    Mesh mesh;
    mesh.topology = Topology::lines;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    mesh.indices = {3, 1, 1, 0};
    LodChain chain;
    optimise(mesh, chain);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 1, 2}));
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{3, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
}

TEST(Optimise, EmptyMeshesStayEmpty) {
    Mesh mesh;
    LodChain chain;
    merge_identical_vertices(mesh);
    optimise(mesh, chain);
    EXPECT_TRUE(mesh.indices.empty());
}

}  // namespace
}  // namespace rambla::assets::test
