#include "bench/render/table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ecs/query.h"
#include "systems/components.h"

namespace rambla::bench {
namespace {

WayCost cost(std::string name, std::vector<double> lighting, std::vector<double> frame) {
    return {.name = std::move(name),
            .passes = {{"lighting", lighting}},
            .lighting = lighting,
            .surfaces = lighting,
            .frame = frame,
            .missing = std::vector<double>(frame.size(), 0.25),
            .cpu = std::vector<double>(frame.size(), 1.5)};
}

/// Rounds whose medians and whose ratios tell apart how they are combined.
Setting measured(std::uint32_t lights, glm::uvec2 size_px, double slower) {
    return {.size_px = size_px,
            .lights = lights,
            .costs = {cost("fullscreen", {10.0 * slower, 60.0 * slower, 20.0 * slower}, {40, 90, 50}),
                      cost("tiled", {10, 20, 20}, {20, 30, 40})}};
}

TEST(RenderBenchTable, JudgesTheCulledPathWhereItIsMeantToBeJudged) {
    const auto judged = [](const Setting& setting) {
        return verdict({setting});
    };
    EXPECT_NE(
        judged(measured(64, {1280, 720}, 3.0)).find("3.00 times as fast as fullscreen, wanted 3.0: holds"),
        std::string::npos)
        << judged(measured(64, {1280, 720}, 3.0));
    EXPECT_NE(
        judged(measured(64, {1280, 720}, 2.9)).find("2.90 times as fast as fullscreen, wanted 3.0: MISSED"),
        std::string::npos);
    EXPECT_EQ(judged(measured(16, {1280, 720}, 3.0)), "");
    EXPECT_EQ(judged(measured(64, {960, 540}, 3.0)), "");
    Setting from_below = measured(64, {1280, 720}, 3.0);
    from_below.view = View::below;
    EXPECT_EQ(judged(from_below), "");
    Setting two_suns = measured(64, {1280, 720}, 3.0);
    two_suns.suns = 2;
    EXPECT_EQ(judged(two_suns), "");
}

TEST(RenderBenchTable, ShowsMediansAndTheRatiosOfEqualPictures) {
    const std::string text = to_text(measured(64, {1280, 720}, 1.0));
    const auto has_line = [&](std::string_view name, std::string_view first, std::string_view second) {
        std::string start{'\n'};
        start.append(name).append(" ");
        const std::size_t at = text.find(start);
        const std::string line =
            at == std::string::npos ? "" : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
        const std::size_t a = line.find(first);
        return a != std::string::npos && line.find(second, a + first.size()) != std::string::npos;
    };
    EXPECT_TRUE(has_line("lighting", "20.00", "20.00")) << text;
    EXPECT_TRUE(has_line("frame", "50.00", "30.00")) << text;
    EXPECT_TRUE(has_line("(missing)", "0.25", "0.25")) << text;
    EXPECT_TRUE(has_line("lighting / tiled", "1.00", "-")) << text;
    EXPECT_TRUE(has_line("frame / tiled", "2.00", "-")) << text;
    EXPECT_NE(text.find("blocks, above, 1280x720, 64 lights, 1 sun: ms, medians of 3 pictures"),
              std::string::npos);
}

TEST(RenderBenchTable, WritesAllValuesAsJson) {
    const nlohmann::json json = to_json(measured(64, {1280, 720}, 1.0));
    EXPECT_EQ(json["lights"], 64);
    EXPECT_EQ(json["ways"][0]["passes_ms"]["lighting"], (std::vector<double>{10, 60, 20}));
    EXPECT_EQ(json["ways"][1]["frame_ms"], (std::vector<double>{20, 30, 40}));
}

TEST(RenderBenchScene, HasTheLightsAndSunsThatItIsAskedFor) {
    for (const std::uint32_t lights : {1u, 5u, 64u}) {
        const game::Stage stage = blocks_with_lights(lights, 2);
        ecs::Query<const systems::LocalLight> local;
        ecs::Query<const systems::DirectionalLight> suns;
        EXPECT_EQ(local.count(*stage.world), lights);
        EXPECT_EQ(suns.count(*stage.world), 1u);
        local.each(*stage.world, [](const systems::LocalLight& light) { EXPECT_EQ(light.radius_m, 20.0f); });
    }
}

}  // namespace
}  // namespace rambla::bench
