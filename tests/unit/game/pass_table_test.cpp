#include "game/pass_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "game/statistics.h"

namespace rambla::game {
namespace {

systems::Feedback frame(double sky_ms, double light_ms, double envelope_ms) {
    systems::Feedback feedback;
    feedback.passes = {{"sky", sky_ms, 0.1, 100, 700}, {"light", light_ms, 0.2, 4000, 900}};
    feedback.gpu_frame_ms = envelope_ms;
    feedback.cpu_frame_ms = 1.0;
    feedback.draws = 7;
    feedback.triangles = 1000;
    feedback.gpu_memory_bytes = 5000;
    return feedback;
}

TEST(Percentile, OfKnownSamples) {
    const std::vector<double> samples{4.0, 1.0, 3.0, 2.0, 5.0};
    EXPECT_DOUBLE_EQ(median(samples), 3.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 1.0), 5.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 0.125), 1.5);
    EXPECT_DOUBLE_EQ(median(std::vector<double>{1.0, 2.0}), 1.5);
    EXPECT_DOUBLE_EQ(median({}), 0.0);
}

TEST(PassTable, AddsUpPassesOfOneNameAndCountsTheirFrameOnce) {
    systems::Feedback twice = frame(1.0, 6.0, 10.0);
    twice.passes.push_back(twice.passes[1]);
    const PassTable table = make_pass_table({twice, twice, frame(1.0, 6.0, 10.0)});
    EXPECT_EQ(table.passes[1].frames, 3u);
    EXPECT_DOUBLE_EQ(table.passes[1].gpu_ms_median, 12.0);
}

TEST(PassTable, MediansSharesAndTheMissingRow) {
    const PassTable table =
        make_pass_table({frame(1.0, 6.0, 10.0), frame(2.0, 5.0, 10.0), frame(3.0, 7.0, 12.0)});
    ASSERT_EQ(table.passes.size(), 2u);
    EXPECT_EQ(table.passes[0].name, "sky");
    EXPECT_DOUBLE_EQ(table.passes[0].gpu_ms_median, 2.0);
    EXPECT_DOUBLE_EQ(table.passes[0].share, 0.2);
    EXPECT_DOUBLE_EQ(table.passes[1].gpu_ms_median, 6.0);
    EXPECT_DOUBLE_EQ(table.passes[1].bytes_written, 4000.0);
    EXPECT_DOUBLE_EQ(table.passes[0].memory_bytes, 700.0);
    EXPECT_DOUBLE_EQ(table.frame.memory_bytes, 900.0);  // the most at any one time, not the sum
    EXPECT_DOUBLE_EQ(table.frame.gpu_ms_median, 10.0);
    EXPECT_DOUBLE_EQ(table.frame.bytes_written, 4100.0);
    // Envelope minus passes: 3, 3, 2.
    EXPECT_DOUBLE_EQ(table.missing.gpu_ms_median, 3.0);
    EXPECT_DOUBLE_EQ(table.missing.share, 0.3);
    EXPECT_NEAR(table.missing.cpu_ms_median, 0.7, 1e-12);  // 1 − 0.1 − 0.2, rounded twice
    EXPECT_EQ(table.draws, 7u);
    EXPECT_EQ(table.triangles, 1000u);
    EXPECT_EQ(table.gpu_memory_bytes, 5000u);
}

TEST(PassTable, PassesThatExceedTheEnvelopeShowAsANegativeMissingRow) {
    EXPECT_DOUBLE_EQ(make_pass_table({frame(6.0, 6.0, 10.0)}).missing.gpu_ms_median, -2.0);
}

TEST(PassTable, APassThatRanInFewFramesCountsAsNothingInTheOthers) {
    systems::Feedback with_hud = frame(1.0, 1.0, 5.0);
    with_hud.passes.push_back({"hud", 3.0, 0.0, 10, 0});
    const PassTable table = make_pass_table({frame(1.0, 1.0, 2.0), with_hud, frame(1.0, 1.0, 2.0)});
    EXPECT_DOUBLE_EQ(table.passes[2].gpu_ms_median, 0.0);
    EXPECT_GT(table.passes[2].gpu_ms_p99, 2.9);
    EXPECT_EQ(table.passes[2].frames, 1u);
    EXPECT_EQ(table.passes[0].frames, 3u);
}

TEST(PassTable, APassThatRunsTwiceInAFrameIsOneRow) {
    systems::Feedback twice = frame(1.0, 2.0, 6.0);
    twice.passes.push_back({"sky", 2.0, 0.0, 100});
    const PassTable table = make_pass_table({twice});
    ASSERT_EQ(table.passes.size(), 2u);
    EXPECT_DOUBLE_EQ(table.passes[0].gpu_ms_median, 3.0);
    EXPECT_DOUBLE_EQ(table.missing.gpu_ms_median, 1.0);
}

TEST(PassTable, NoFramesAreATableOfNothing) {
    const PassTable table = make_pass_table({});
    EXPECT_TRUE(table.passes.empty());
    EXPECT_DOUBLE_EQ(table.frame.gpu_ms_median, 0.0);
}

TEST(PassTable, TextAndJsonNameEveryRow) {
    const PassTable table = make_pass_table({frame(1.0, 6.0, 10.0)});
    const std::string text = to_text(table);
    for (const char* const name : {"sky", "light", "(missing)", "frame"})
        EXPECT_THAT(text, testing::HasSubstr(name));
    const nlohmann::json json = to_json(table);
    EXPECT_EQ(json["passes"].size(), 2u);
    EXPECT_DOUBLE_EQ(json["passes"][1]["gpu_ms_median"].get<double>(), 6.0);
    EXPECT_DOUBLE_EQ(json["missing"]["gpu_ms_median"].get<double>(), 3.0);
    EXPECT_DOUBLE_EQ(json["frame"]["gpu_ms_median"].get<double>(), 10.0);
}

TEST(BytesText, ChoosesAReadableUnit) {
    EXPECT_EQ(bytes_text(12.0), "12 B");
    EXPECT_EQ(bytes_text(1536.0), "1.5 KiB");
    EXPECT_EQ(bytes_text(340.0 * 1024.0), "340 KiB");
    EXPECT_EQ(bytes_text(1.5 * 1024.0 * 1024.0 * 1024.0), "1.5 GiB");
}

}  // namespace
}  // namespace rambla::game
