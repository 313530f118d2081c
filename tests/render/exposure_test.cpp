// How exposure follows what is seen, in time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "render/display_harness.h"
#include "render/post/adaptation.h"
#include "render/shader_harness.h"

namespace {

using namespace rambla;
using render::followed_ev;
using render::followed_shares;
using render::FollowedShares;
using render::target_ev;
using tests::DisplayHarness;
using tests::Light;
using tests::Random;

Light grey(float level) {
    return Light{{5, 3}, glm::vec3{level}};
}

/// All of the difference is made up for, and nothing bounds it, so that the target is a number of stops.
struct Following : testing::Test {
    Following() {
        gpu.settings.exposure.strength = 1.0f;
        gpu.settings.exposure.range_ev = 10.0f;
        gpu.settings.exposure.delta = 1e-6f;
        gpu.settings.exposure.key = 0.1f;
    }
    /// EV after a frame in grey light.
    double frame(float level, double time_s) { return gpu.show(grey(level), time_s).exposure->ev; }
    DisplayHarness gpu;
};

TEST_F(Following, IsAtItsTargetInTheFirstFrame) {
    EXPECT_NEAR(frame(0.1f, 3.0), 0.0, 1e-4);
    DisplayHarness another;
    another.settings = gpu.settings;
    // A key of 0.1 and light of 0.1·2^6; logarithms of llvmpipe are right to about 1e-5.
    EXPECT_NEAR(another.show(grey(6.4f), 100.0).exposure->ev, -6.0, 1e-4);
}

TEST_F(Following, IsExactForAnyFrameTime) {
    const struct {
        double dt_s;
        int frames;
    } runs[] = {{1e-4, 3000}, {1e-3, 1000}, {1.0 / 60.0, 120}, {0.1, 30}, {1.0, 5}};
    for (const auto& run : runs) {
        for (const float level : {6.4f, 0.1f / 64.0f}) {
            gpu.cut = true;
            static_cast<void>(frame(0.1f, 0.0));
            gpu.cut = false;
            const double target = level > 1.0f ? -6.0 : 6.0;
            const double tau =
                static_cast<double>(level > 1.0f ? gpu.settings.exposure.down_s : gpu.settings.exposure.up_s);
            double ev = 0.0;
            for (int i = 1; i <= run.frames; ++i) {
                ev = frame(level, i * run.dt_s);
                // 2e-4 of the six stops: the target's own error, see above, and none that grows.
                ASSERT_NEAR(ev, target * -std::expm1(-i * run.dt_s / tau), 1.2e-3)
                    << "frame " << i << " of " << run.dt_s << " s";
            }
        }
    }
}

TEST_F(Following, OfAHundredthOfAStopIsExactInTenthsOfMilliseconds) {
    // Six stops away from 0, where floats are 5e-7 apart, and steps begin at 8e-7.
    const double start = frame(6.4f, 0.0);
    const float darker = 6.4f * std::exp2(-0.01f);
    double ev = 0.0;
    for (int i = 1; i <= 3000; ++i)
        ev = frame(darker, i * 1e-4);
    gpu.cut = true;
    const double target = frame(darker, 0.3);
    EXPECT_NEAR(target - start, 0.01, 1e-4);
    const double tau = static_cast<double>(gpu.settings.exposure.up_s);
    EXPECT_NEAR(ev, target + (start - target) * std::exp(-0.3 / tau), 2e-6);
}

TEST_F(Following, OfALongTimeDoesNotDependOnHowItIsDivided) {
    const auto after_half_a_second = [&](int frames) {
        gpu.cut = true;
        static_cast<void>(frame(0.1f, 0.0));
        gpu.cut = false;
        double ev = 0.0;
        for (int i = 1; i <= frames; ++i)
            ev = frame(6.4f, 0.5 * i / frames);
        return ev;
    };
    const double once = after_half_a_second(1);
    // Shares are passed as floats, 6e-8 of each: the sum of 2000 such errors stays below 1e-6 of six stops.
    EXPECT_NEAR(after_half_a_second(2000), once, 6e-6);
    EXPECT_NEAR(after_half_a_second(7), once, 6e-6);
}

TEST_F(Following, OfAStepOfSixStopsAndBackIsMonotoneAndPassesNoTarget) {
    double time_s = 0.0;
    double before = frame(0.1f, time_s);
    Random random;
    for (const double sign : {-1.0, 1.0, 1.0, -1.0}) {  // bright, back, dark, back
        const double target = before + 6.0 * sign;
        const float level = static_cast<float>(0.1 * std::exp2(-target));
        for (int i = 0; i < 600; ++i) {
            time_s += 0.04 * static_cast<double>(random());
            const double now = frame(level, time_s);
            ASSERT_GE(sign * (now - before), 0.0) << "turns round at " << time_s << " s";
            ASSERT_LT(sign * (now - target), 0.01 * 6.0) << "overshoots at " << time_s << " s";
            before = now;
        }
        EXPECT_NEAR(before, target, 0.01) << "12 s are ten times the slower of the two";
    }
}

TEST_F(Following, HoldsWhereTheClockStandsOrIsNoClock) {
    static_cast<void>(frame(0.1f, 5.0));
    const double some = frame(6.4f, 5.1);
    EXPECT_LT(some, -1.0);
    EXPECT_EQ(frame(6.4f, 5.1), some) << "no time has passed";
    EXPECT_EQ(frame(6.4f, 2.0), some) << "the clock was put back";
    EXPECT_EQ(frame(6.4f, std::numeric_limits<double>::quiet_NaN()), some);
    EXPECT_EQ(frame(6.4f, 2.0), some) << "time since a time that is none";
    const double tiny = frame(6.4f, 2.0 + 1e-6);
    EXPECT_LE(tiny, some);
    EXPECT_NEAR(tiny, some, 2e-5);
    EXPECT_NEAR(frame(6.4f, 12.0), -6.0, 1e-3) << "ten seconds";
    EXPECT_NEAR(frame(0.1f, std::numeric_limits<double>::infinity()), 0.0, 1e-4);
}

TEST_F(Following, JumpsAfterACutAndAfterAWhileWithoutIt) {
    static_cast<void>(frame(0.1f, 0.0));
    gpu.cut = true;
    EXPECT_NEAR(frame(6.4f, 0.0), -6.0, 1e-3);
    gpu.cut = false;
    EXPECT_NEAR(frame(0.1f, 0.001), -6.0, 0.1);
    gpu.settings.exposure.mode = render::ExposureMode::fixed;
    EXPECT_FALSE(gpu.show(grey(0.1f), 0.002).exposure.has_value());
    gpu.settings.exposure.mode = render::ExposureMode::automatic;
    EXPECT_NEAR(frame(0.4f, 0.003), -2.0, 1e-3);
}

TEST_F(Following, StaysWithinItsRange) {
    gpu.settings.exposure.range_ev = 2.0f;
    gpu.cut = true;
    EXPECT_EQ(frame(60000.0f, 0.0), -2.0);
    EXPECT_EQ(frame(0.0f, 0.0), 2.0);
}

TEST_F(Following, ShowsThePictureAsMuchBrighter) {
    gpu.settings.exposure.strength = 0.5f;
    gpu.settings.tone = {
        .curve = render::ToneCurve::extended, .white = 1.0f, .dither = false};  // the identity
    const auto shown = gpu.show(grey(0.025f));                                  // two stops below the key
    EXPECT_NEAR(shown.exposure->ev, 1.0, 1e-3);
    // 0.05 in sRGB is 63.4.
    EXPECT_NEAR(shown.display(0).y, 63.4, 1.0);
}

TEST(Adaptation, OnTheCpuIsThatOfTheGpu) {
    DisplayHarness gpu;
    render::ExposureParameters& parameters = gpu.settings.exposure;
    parameters = {
        .delta = 1e-6f, .key = 0.3f, .strength = 0.7f, .range_ev = 5.0f, .up_s = 2.0f, .down_s = 0.3f};
    Random random;
    double ev = 0.0;
    double before_s = 0.0;
    for (int i = 0; i < 200; ++i) {
        const float level = std::exp2(12.0f * random() - 8.0f);
        const double time_s = before_s + static_cast<double>(random());
        const double found = gpu.show(grey(level), time_s).exposure->ev;
        const double target = target_ev(static_cast<double>(level), parameters);
        ev = i == 0 ? target : followed_ev(ev, target, followed_shares(time_s - before_s, parameters));
        EXPECT_NEAR(found, ev, 1e-3);
        before_s = time_s;
    }
}

TEST(Adaptation, NeverLeavesTheWayToItsTargetWhateverTheNumbers) {
    std::mt19937 engine{5};
    std::uniform_int_distribution<std::uint64_t> bits;
    std::uniform_real_distribution<double> stops{-10.0, 10.0};
    for (int i = 0; i < 200'000; ++i) {
        double dt_s = 0.0;
        const std::uint64_t pattern = bits(engine);  // any double: denormal, huge, infinite, NaN, negative
        std::memcpy(&dt_s, &pattern, sizeof(dt_s));
        render::ExposureParameters parameters;
        parameters.up_s =
            i % 7 == 0 ? 0.0f : static_cast<float>(60.0 * std::exp2(2.0 * stops(engine) - 20.0));
        const FollowedShares shares = followed_shares(dt_s, parameters);
        for (const double share : {shares.up, shares.down}) {
            ASSERT_GE(share, 0.0) << dt_s;
            ASSERT_LE(share, 1.0) << dt_s;
        }
        const double from = stops(engine), target = stops(engine);
        const double to = followed_ev(from, target, shares);
        ASSERT_GE(to, std::min(from, target));
        ASSERT_LE(to, std::max(from, target));
    }
}

}  // namespace
