#include "render/passes/light_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>
#include <vector>

namespace rambla::render {
namespace {

systems::FrameView view_of(glm::uvec2 size_px) {
    systems::FrameView view;
    view.size_px = size_px;
    const float f = 1.0f / std::tan(0.5f);
    view.clip_from_view = glm::mat4{0.0f};
    view.clip_from_view[0][0] = f * static_cast<float>(size_px.y) / static_cast<float>(size_px.x);
    view.clip_from_view[1][1] = f;
    view.clip_from_view[2][3] = -1.0f;
    view.clip_from_view[3][2] = 0.05f;
    return view;
}

/// The cell of a point as the shader finds it, in its own precision.
std::size_t cell_of(const shared::LightGrid& grid, glm::uvec2 pixel, float distance_m) {
    const glm::uvec2 tile = glm::min(pixel / grid.cells.w, glm::uvec2{grid.cells} - 1u);
    const float slice = std::floor(std::log2(distance_m) * grid.slicing.x + grid.slicing.y);
    const auto deep = static_cast<std::size_t>(std::clamp(slice, 0.0f, static_cast<float>(grid.cells.z - 1)));
    return (std::size_t{tile.y} * grid.cells.x + tile.x) * grid.cells.z + deep;
}

std::vector<systems::FrameLight> random_lights(std::size_t count, std::mt19937& random) {
    std::uniform_real_distribution<float> across{-60.0f, 60.0f}, ahead{-120.0f, 5.0f}, size{-3.0f, 4.0f};
    std::vector<systems::FrameLight> lights(count);
    for (systems::FrameLight& light : lights) {
        light.position_m = {across(random), 0.3f * across(random), ahead(random)};
        light.radius_m = std::exp2(size(random));  // 12 cm to 16 m
    }
    return lights;
}

TEST(LightBins, NoVisiblePointLacksALightThatReachesIt) {
    std::mt19937 random{5};
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> uniform;
    for (const glm::uvec2 size_px : {glm::uvec2{640, 360}, glm::uvec2{333, 77}, glm::uvec2{1, 1}}) {
        const systems::FrameView view = view_of(size_px);
        const std::vector<systems::FrameLight> lights = random_lights(100, random);
        std::vector<BoundedLight> bounded;
        bound_lights(view, lights, bounded);
        for (const std::uint32_t slices : {1u, 2u, 16u, 64u}) {
            LightBinner binner;
            const LightBins& bins = binner.bin(size_px, bounded, 64, slices);
            int seen = 0;
            for (std::uint32_t light = 0; light < lights.size(); ++light) {
                for (int i = 0; i < 200; ++i) {
                    const glm::vec3 direction =
                        glm::normalize(glm::vec3{normal(random), normal(random), normal(random)});
                    // Up to the very rim, where bounds are tightest.
                    const float reach = lights[light].radius_m * std::min(1.0f, 1.2f * uniform(random));
                    const glm::vec3 point = lights[light].position_m + reach * direction;
                    const glm::vec4 clip = view.clip_from_view * glm::vec4{point, 1.0f};
                    const glm::vec2 place = (0.5f * glm::vec2{clip} / clip.w + 0.5f) * glm::vec2{size_px};
                    const bool inside = clip.w > 0.05f && place.x >= 0.0f && place.y >= 0.0f &&
                                        place.x < static_cast<float>(size_px.x) &&
                                        place.y < static_cast<float>(size_px.y);
                    if (!inside) continue;
                    ++seen;
                    const glm::uvec2 range = bins.ranges[cell_of(bins.grid, glm::uvec2{place}, -point.z)];
                    const auto first = bins.entries.begin() + range.x;
                    ASSERT_TRUE(std::binary_search(first, first + range.y, light))
                        << "light " << light << " at " << point.z << " m, " << slices << " slices";
                }
            }
            EXPECT_GT(seen, size_px.x > 1 ? 1000 : 0);
        }
    }
}

TEST(LightBins, ListsFollowEachOtherAndAscend) {
    std::mt19937 random{6};
    const systems::FrameView view = view_of({640, 360});
    const std::vector<systems::FrameLight> lights = random_lights(300, random);
    std::vector<BoundedLight> bounded;
    bound_lights(view, lights, bounded);
    LightBinner binner;
    const LightBins& bins = binner.bin(view.size_px, bounded, 32, 16);
    EXPECT_EQ(bins.ranges.size(), 20u * 12u * 16u);
    std::uint32_t next = 0;
    for (const glm::uvec2 range : bins.ranges) {
        ASSERT_EQ(range.x, next);
        next += range.y;
        EXPECT_TRUE(std::is_sorted(bins.entries.begin() + range.x, bins.entries.begin() + next));
    }
    EXPECT_EQ(next, bins.entries.size());
    // Most cells must be spared by most lights, or there would be no point in cells.
    EXPECT_LT(static_cast<double>(bins.entries.size()),
              0.02 * static_cast<double>(bins.ranges.size() * lights.size()));
}

TEST(LightBins, LightsThatAreNoNumbersReachNothingAndEndlessOnesEverything) {
    constexpr float k_endless = std::numeric_limits<float>::infinity();
    constexpr float k_no_number = std::numeric_limits<float>::quiet_NaN();
    const systems::FrameView view = view_of({640, 360});
    std::vector<systems::FrameLight> lights(5);
    lights[0].radius_m = k_no_number;
    lights[1] = {.position_m = {k_no_number, 0, 0}, .radius_m = 5.0f};
    lights[2] = {.position_m = {0, k_endless, 0}, .radius_m = 5.0f};
    lights[3] = {.position_m = {0, 0, -5}, .radius_m = 0.0f};
    lights[4] = {.position_m = {0, 0, -5}, .radius_m = k_endless};
    std::vector<BoundedLight> bounded;
    bound_lights(view, lights, bounded);
    ASSERT_EQ(bounded.size(), 1u);
    EXPECT_EQ(bounded[0].light, 4u);
    EXPECT_EQ(bounded[0].bounds.nearest_m, 0.0f);
    EXPECT_GT(bounded[0].bounds.depth, 0.0f);
    LightBinner binner;
    const LightBins& bins = binner.bin(view.size_px, bounded, 64, 16);
    EXPECT_TRUE(std::ranges::all_of(bins.ranges, [](glm::uvec2 range) { return range.y == 1; }));
}

TEST(LightBins, TooManyLightsEverywhereGetLargerCells) {
    const systems::FrameView view = view_of({1920, 1080});
    for (const std::size_t count : {1000u, 4000u, 400'000u}) {
        const std::vector<systems::FrameLight> lights(count, {.position_m = {0, 0, -5}, .radius_m = 1e4f});
        std::vector<BoundedLight> bounded;
        bound_lights(view, lights, bounded);
        ASSERT_EQ(bounded.size(), count);
        LightBinner binner;
        const LightBins& bins = binner.bin(view.size_px, bounded, 32, 16);
        EXPECT_LE(bins.entries.size(), k_most_light_entries);
        EXPECT_GT(bins.entries.size(), k_most_light_entries / 8);  // no larger cells than need be
        EXPECT_TRUE(std::ranges::all_of(bins.ranges, [&](glm::uvec2 range) { return range.y == count; }));
        const shared::LightGrid& grid = bins.grid;
        EXPECT_EQ(bins.ranges.size(), std::size_t{grid.cells.x} * grid.cells.y * grid.cells.z);
        EXPECT_EQ(grid.cells.x, (view.size_px.x + grid.cells.w - 1) / grid.cells.w);
    }
    LightBinner finest;
    const LightBins& fine = finest.bin({8192, 8192}, {}, 8, 64);
    EXPECT_LE(fine.ranges.size(), k_most_light_cells);
    EXPECT_GT(fine.ranges.size(), k_most_light_cells / 8);
    // What fits keeps the cells that are asked for.
    std::vector<BoundedLight> bounded;
    bound_lights(view, std::vector<systems::FrameLight>(100, {.position_m = {0, 0, -5}, .radius_m = 1e4f}),
                 bounded);
    LightBinner binner;
    EXPECT_EQ(binner.bin(view.size_px, bounded, 32, 16).grid.cells, glm::uvec4(60, 34, 16, 32));
}

TEST(LightBins, WithoutLightsAllCellsAreEmpty) {
    LightBinner binner;
    const LightBins& bins = binner.bin({100, 100}, {}, 64, 16);
    EXPECT_TRUE(bins.entries.empty());
    EXPECT_TRUE(std::ranges::all_of(bins.ranges, [](glm::uvec2 range) { return range.y == 0; }));
}

}  // namespace
}  // namespace rambla::render
