#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "system/program.h"

namespace rambla::system_test {
namespace {

struct CompareProgram : testing::Test {
    ScratchFolder scratch;

    nlohmann::json json(const std::vector<std::string>& arguments) {
        const Ended ended = rambla(arguments, scratch.path());
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return nlohmann::json::parse(ended.out);
    }
};

TEST_F(CompareProgram, MeasuresBlocksWithEveryEffectThatThereIs) {
    const nlohmann::json result =
        json({"walk", "--scene", "blocks", "--compare", "--size", "160x90", "--frames", "5", "--json", "-"});
    EXPECT_EQ(result["schema"], "rambla.compare/1");
    EXPECT_EQ(result["scene"], "blocks");
    EXPECT_EQ(result["frames"], 5);
    EXPECT_EQ(result["steps"], 5);
    EXPECT_EQ(result["counted"], 4);
    EXPECT_EQ(result["width_px"], 160);
    EXPECT_EQ(result["height_px"], 90);
    EXPECT_EQ(result["features"],
              (nlohmann::json{"hdr", "tone-mapping", "bloom", "fxaa", "sun-shadow", "point-lights"}));
    const double median = result["frame_ms_median"];
    EXPECT_GT(result["frame_ms_p10"].get<double>(), 0.0);
    EXPECT_GE(median, result["frame_ms_p10"].get<double>());
    EXPECT_LE(median, result["frame_ms_p90"].get<double>());
    // A frame is complete only after its step and its packing.
    EXPECT_GT(median, result["update_ms_p10"].get<double>() + result["look_ms_p10"].get<double>());
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "out")) << "no pictures";
}

TEST_F(CompareProgram, MeasuresAgentsWithoutPostEffectsAndAsMovedByAnyNumberOfThreads) {
    const auto run = [&](const char* threads) {
        return json({"walk", "--scene", "agents", "--compare", "--size", "160x90", "--frames", "3",
                     "--threads", threads, "--json", "-"});
    };
    const nlohmann::json one = run("1");
    EXPECT_EQ(one["features"], (nlohmann::json{"hdr", "tone-mapping", "sun-shadow"}));
    EXPECT_GT(one["update_ms_median"].get<double>(), 0.0);
    EXPECT_GE(one["entities"], 10'000);
    EXPECT_EQ(run("3")["state_hash"], one["state_hash"]);
}

}  // namespace
}  // namespace rambla::system_test
