#include "game/run_stats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace rambla::game {
namespace {

std::vector<HeldSample> run(std::uint64_t frames, const std::function<void(HeldSample&)>& change) {
    std::vector<HeldSample> samples;
    for (std::uint64_t i = 0; i < frames; ++i) {
        samples.push_back({.frame = i,
                           .heap_bytes = 200u << 20u,
                           .resident_bytes = 300u << 20u,
                           .gpu_bytes = 1000,
                           .gl_objects = 40});
        change(samples.back());
    }
    return samples;
}

TEST(Steadiness, AConstantRunIsSteady) {
    const Steadiness result = steadiness(run(200, [](HeldSample&) {}));
    EXPECT_TRUE(result.known);
    EXPECT_TRUE(result.steady);
}

TEST(Steadiness, GrowthBeforeTheRunHasSettledDoesNotCount) {
    EXPECT_TRUE(steadiness(run(200, [](HeldSample& s) {
                    s.gl_objects = s.frame < 50 ? 10 + s.frame % 7 : 40;
                })).steady);
}

TEST(Steadiness, OneGlObjectTooManyIsSeen) {
    const Steadiness result =
        steadiness(run(200, [](HeldSample& s) { s.gl_objects += s.frame >= 190 ? 1 : 0; }));
    EXPECT_FALSE(result.steady);
    EXPECT_EQ(result.gl_object_growth, 1);
}

TEST(Steadiness, AFramesWorthOfLeakedPixelsIsSeen) {
    // 64 KiB a frame: a 160×100 picture.
    const Steadiness result = steadiness(run(200, [](HeldSample& s) { s.heap_bytes += s.frame << 16u; }));
    EXPECT_FALSE(result.steady);
    // Medians of the first and the last quarter lie 113 frames apart.
    EXPECT_NEAR(static_cast<double>(result.heap_growth_bytes), 113.0 * 65536.0, 65536.0);
}

TEST(Steadiness, PicturesInFlightDoNotCountAsGrowth) {
    EXPECT_TRUE(steadiness(run(200, [](HeldSample& s) { s.heap_bytes += (s.frame % 5) << 20u; })).steady);
}

TEST(Steadiness, BinsOfOneMoreDriverSceneAreNoGrowth) {
    EXPECT_TRUE(steadiness(run(200, [](HeldSample& s) {
                    s.resident_bytes += s.frame > 110 ? 36u << 20u : 0u;
                })).steady);
}

TEST(Steadiness, APictureLeakedPerFrameOutsideTheHeapIsSeen) {
    // 2 MiB a frame: what a driver leaks that keeps every read-back of 960×540.
    const auto result = steadiness(run(200, [](HeldSample& s) { s.resident_bytes += s.frame << 21u; }));
    EXPECT_FALSE(result.steady);
}

TEST(Steadiness, GpuMemoryMayNotGrowAtAll) {
    EXPECT_FALSE(steadiness(run(200, [](HeldSample& s) { s.gpu_bytes += s.frame > 180 ? 1 : 0; })).steady);
}

TEST(Steadiness, AShortRunTellsNothing) {
    const std::vector<HeldSample> samples = run(52, [](HeldSample&) {});
    EXPECT_FALSE(steadiness(samples).known);
    EXPECT_THAT(to_text(samples, 10), testing::HasSubstr("too few frames"));
    EXPECT_FALSE(steadiness({}).known);
}

TEST(Steadiness, TheLastLineSaysSteadyOrByHowMuch) {
    EXPECT_THAT(to_text(run(200, [](HeldSample&) {}), 10),
                testing::HasSubstr("memory: steady over frames 50 to 199"));
    EXPECT_THAT(to_text(run(200, [](HeldSample& s) { s.gl_objects += static_cast<unsigned>(s.frame); }), 10),
                testing::HasSubstr("memory: grew"));
}

}  // namespace
}  // namespace rambla::game
