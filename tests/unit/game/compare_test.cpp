#include "game/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rambla::game {
namespace {

TEST(Compare, ForcesItsEffectsOnAndLeavesTheRest) {
    render::Settings chosen;
    chosen.anti_aliasing.method = render::AntiAliasing::none;
    chosen.shadows.method = render::ShadowMethod::off;
    chosen.tone.curve = render::ToneCurve::filmic;
    const render::Settings blocks = compare_settings(chosen, "blocks");
    EXPECT_EQ(blocks.anti_aliasing.method, render::AntiAliasing::fxaa);
    EXPECT_EQ(blocks.shadows.method, render::ShadowMethod::focused);
    EXPECT_EQ(blocks.shadows.size_texels, 2048);
    EXPECT_EQ(blocks.tone.curve, render::ToneCurve::filmic);
    EXPECT_EQ(blocks.exposure.mode, render::ExposureMode::fixed);
    EXPECT_EQ(blocks.bloom.method, render::BloomMethod::pyramid);
    const render::Settings agents = compare_settings({}, "agents");
    EXPECT_EQ(agents.bloom.method, render::BloomMethod::off);
    EXPECT_EQ(agents.anti_aliasing.method, render::AntiAliasing::none);
    EXPECT_EQ(agents.shadows.size_texels, 2048);
}

TEST(Compare, CountsFourFifthsOfTheFrames) {
    EXPECT_EQ(uncounted(100), 20u);
    EXPECT_EQ(uncounted(5), 1u);
    EXPECT_EQ(uncounted(1), 0u);
}

TEST(Compare, StatesMedianAndTenths) {
    CompareMeasures measures{.scene = "blocks", .size_px = {320, 180}, .frames = 14};
    for (int i = 0; i <= 10; ++i) {
        measures.frame_ms.push_back(10.0 * i);
        measures.update_ms.push_back(i);
        measures.look_ms.push_back(0.5);
    }
    measures.features = {"hdr", "fxaa"};
    const nlohmann::json json = compare_json(measures);
    EXPECT_EQ(json["schema"], "rambla.compare/1");
    EXPECT_EQ(json["counted"], 11);
    EXPECT_EQ(json["frame_ms_median"], 50.0);
    EXPECT_EQ(json["frame_ms_p10"], 10.0);
    EXPECT_EQ(json["frame_ms_p90"], 90.0);
    EXPECT_EQ(json["update_ms_median"], 5.0);
    EXPECT_EQ(json["look_ms_p90"], 0.5);
    EXPECT_EQ(json["features"], (nlohmann::json{"hdr", "fxaa"}));
    EXPECT_THAT(compare_text(measures), testing::HasSubstr("features=hdr,fxaa"));
}

}  // namespace
}  // namespace rambla::game
