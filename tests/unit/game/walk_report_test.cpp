#include "game/walk_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rambla::game {
namespace {

WalkMeasures walk_of(std::size_t frames) {
    WalkMeasures measures;
    measures.run_s = 2.0;
    measures.drawn.resize(frames);
    return measures;
}

TEST(WalkReport, StatesTheTimeOfAFrame) {
    WalkMeasures measures = walk_of(5);
    measures.frame_ms = {10.0, 30.0, 20.0};
    EXPECT_THAT(summary_text(measures), testing::HasSubstr("2.50 frames per second; a frame takes 20.0 ms"));
    EXPECT_EQ(summary_json(measures)["frame_ms_median"], 20.0);
    // Interpolated between the two largest of three: 20 + 0.98 * 10.
    EXPECT_NEAR(summary_json(measures)["frame_ms_p99"].get<double>(), 29.8, 1e-9);
}

TEST(WalkReport, StatesWhatTexturesTookAfterTheLastFrame) {
    WalkMeasures measures = walk_of(2);
    measures.drawn[1].gpu_memory_bytes = 9000;
    measures.drawn[1].textures = {.resident_bytes = 5 << 20,
                                  .peak_bytes = 6 << 20,
                                  .budget_bytes = 8 << 20,
                                  .loads = 7,
                                  .pending_loads = 2,
                                  .below_demand = 3};
    EXPECT_THAT(
        summary_text(measures),
        testing::HasSubstr("textures 5.0 MiB resident, 6.0 MiB at most, of a budget of 8.0 MiB; 7 loads, 2 "
                           "pending, 3 images coarser"));
    const nlohmann::json json = summary_json(measures);
    EXPECT_EQ(json["gpu_memory_bytes"], 9000);
    EXPECT_EQ(json["textures"]["resident_bytes"], 5 << 20);
    EXPECT_EQ(json["textures"]["peak_bytes"], 6 << 20);
    EXPECT_EQ(json["textures"]["budget_bytes"], 8 << 20);
    EXPECT_EQ(json["textures"]["loads"], 7);
    EXPECT_EQ(json["textures"]["pending_loads"], 2);
    EXPECT_EQ(json["textures"]["below_demand"], 3);
}

TEST(WalkReport, StatesWhereExposureEndedAndTheMostBrokenPixels) {
    WalkMeasures measures = walk_of(3);
    EXPECT_TRUE(summary_json(measures)["exposure"].is_null()) << "fixed: nothing has looked";
    measures.drawn[1].exposure = {.known = true, .bad_pixels = 7};
    measures.drawn[2].exposure = {
        .known = true, .departure_ev = -0.5, .average_luminance = 0.25, .bad_pixels = 2};
    const nlohmann::json json = summary_json(measures)["exposure"];
    EXPECT_EQ(json["departure_ev"], -0.5);
    EXPECT_EQ(json["average_luminance"], 0.25);
    EXPECT_EQ(json["bad_pixels_most"], 7);
}

TEST(WalkReport, AWalkTooShortForFrameTimesStatesNone) {
    const WalkMeasures measures = walk_of(2);
    EXPECT_THAT(summary_text(measures), testing::HasSubstr("1.00 frames per second\n"));
    EXPECT_THAT(summary_text(measures), testing::Not(testing::HasSubstr("a frame takes")));
    EXPECT_TRUE(summary_json(measures)["frame_ms_median"].is_null());
    EXPECT_TRUE(summary_json(measures)["frame_ms_p99"].is_null());
}

}  // namespace
}  // namespace rambla::game
