#include "game/study/metrics/temporal.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "unit/game/study/metrics/pictures.h"

namespace rambla::game::study {
namespace {

using Mask = std::vector<std::uint8_t>;

// Values are sums of powers of two, so that what is expected is exact.
const Picture k_grey = filled(4, 4, glm::vec3{0.5f});
const Mask k_everywhere(16, 1);

TEST(Flicker, IsZeroWhereNothingChanges) {
    EXPECT_EQ(flicker_pct({k_grey, k_grey}, {k_grey, k_grey}, 0.0), 0.0);
}

TEST(Flicker, OnePixelOfSixteenIsSeen) {
    const Picture after = with(k_grey, 1, 2, {0.5f, 0.5f, 0.75f});
    EXPECT_DOUBLE_EQ(flicker_pct({k_grey, k_grey}, {k_grey, after}, 0.0), 6.25);
    EXPECT_DOUBLE_EQ(flicker_pct({k_grey, k_grey}, {k_grey, after}, 0.25), 0.0);
}

TEST(Flicker, DoesNotCountWhatTheReferenceChanges) {
    const Picture both = with(with(k_grey, 1, 2, k_white), 3, 3, k_white);
    const Picture one = with(k_grey, 1, 2, k_black);  // another change, at the same place
    EXPECT_DOUBLE_EQ(flicker_pct({k_grey, one}, {k_grey, both}, 0.0), 6.25);
    EXPECT_DOUBLE_EQ(flicker_pct({k_grey, both}, {k_grey, one}, 0.0), 0.0);
}

TEST(Flicker, IsNoMatterOfAConstantError) {
    const Picture wrong = noise(4, 4, 1);
    EXPECT_EQ(flicker_pct({k_grey, k_grey}, {wrong, wrong}, 0.0), 0.0);
}

TEST(Flicker, ATexelThatBecomesNanChanges) {
    const Picture after = with(k_grey, 0, 0, glm::vec3{std::numeric_limits<float>::quiet_NaN()});
    EXPECT_DOUBLE_EQ(flicker_pct({k_grey, k_grey}, {k_grey, after}, 100.0), 6.25);
    EXPECT_DOUBLE_EQ(flicker_pct({k_grey, k_grey}, {after, after}, 0.0), 0.0);
}

TEST(Flicker, RefusesUnequalSizes) {
    EXPECT_THROW(static_cast<void>(flicker_pct({k_grey, k_grey}, {k_grey, filled(2, 8, k_black)}, 0.0)),
                 std::invalid_argument);
}

TEST(Pop, IsTheMeanChangeBeyondTheReferences) {
    const Picture darker = filled(4, 4, glm::vec3{0.25f});
    const Picture brighter = filled(4, 4, glm::vec3{0.625f});
    EXPECT_DOUBLE_EQ(pop_linear({k_grey, k_grey}, {k_grey, darker}, k_everywhere), 0.25);
    EXPECT_DOUBLE_EQ(pop_linear({k_grey, brighter}, {k_grey, darker}, k_everywhere), 0.125);
    EXPECT_DOUBLE_EQ(pop_linear({k_grey, darker}, {k_grey, brighter}, k_everywhere), 0.0);
}

TEST(Pop, OfOneChannelOfOnePixelIsItsShareOfTheObject) {
    const Picture after = with(k_grey, 2, 1, {0.5f, 1.0f, 0.5f});
    EXPECT_DOUBLE_EQ(pop_linear({k_grey, k_grey}, {k_grey, after}, k_everywhere), 0.5 / 48.0);
    Mask object(16, 0);
    EXPECT_EQ(pop_linear({k_grey, k_grey}, {k_grey, after}, object), 0.0);
    object[1 * 4 + 2] = 255;
    EXPECT_DOUBLE_EQ(pop_linear({k_grey, k_grey}, {k_grey, after}, object), 0.5 / 3.0);
}

TEST(Pop, IsNoneWhereTheSameChangeIsElsewhere) {
    const Picture here = with(k_grey, 0, 0, k_white);
    const Picture there = with(k_grey, 3, 3, k_white);
    EXPECT_EQ(pop_linear({k_grey, here}, {k_grey, there}, k_everywhere), 0.0);
}

TEST(Pop, TakesWhatIsNotFiniteForBlack) {
    const Picture after = with(k_grey, 2, 1, glm::vec3{std::numeric_limits<float>::infinity()});
    EXPECT_DOUBLE_EQ(pop_linear({k_grey, k_grey}, {k_grey, after}, k_everywhere), 0.5 / 16.0);
}

TEST(Pop, RefusesAMaskThatDoesNotFit) {
    EXPECT_THROW(static_cast<void>(pop_linear({k_grey, k_grey}, {k_grey, k_grey}, Mask(15, 1))),
                 std::invalid_argument);
}

/// Follows a test that has these lights in turn, and a reference that stays.
Pops pops_of(const std::vector<float>& lights, double frame_s) {
    PopMeter meter{frame_s};
    for (const float light : lights)
        meter.add(k_grey, filled(4, 4, glm::vec3{light}), k_everywhere);
    return meter.result();
}

TEST(PopMeter, FindsTheLargestStep) {
    const Pops pops = pops_of({0.5f, 0.5f, 0.75f, 0.625f, 0.625f}, 1.0 / 60.0);
    EXPECT_DOUBLE_EQ(pops.max_linear, 0.25);
    EXPECT_DOUBLE_EQ(pops.in_100ms_linear, 0.0);  // shorter
}

TEST(PopMeter, AddsUpSmallStepsWithin100Milliseconds) {
    // 60 Hz: six frames. A fade of 1/16 a frame over eight frames.
    std::vector<float> lights(10, 0.0f);
    for (int i = 1; i <= 8; ++i)
        lights.push_back(0.0625f * static_cast<float>(i));
    lights.resize(30, 0.5f);
    const Pops pops = pops_of(lights, 1.0 / 60.0);
    EXPECT_DOUBLE_EQ(pops.max_linear, 0.0625);
    EXPECT_DOUBLE_EQ(pops.in_100ms_linear, 6.0 * 0.0625);
    EXPECT_DOUBLE_EQ(pops_of(lights, 0.05).in_100ms_linear, 2.0 * 0.0625);  // 20 Hz: two frames
    EXPECT_DOUBLE_EQ(pops_of(lights, 1.0).in_100ms_linear, 0.0625);         // one at least
}

TEST(PopMeter, PercentileIsOverFrames) {
    // 201 frames, 200 steps, of which the last two are 1/4 and 1/2: 1 % lies above the 99th percentile, the
    // place 0.99 · 199 = 197.01 between a still frame and the smaller step.
    std::vector<float> lights(199, 0.0f);
    lights.push_back(0.25f);
    lights.push_back(0.75f);
    const Pops pops = pops_of(lights, 1.0 / 60.0);
    EXPECT_DOUBLE_EQ(pops.max_linear, 0.5);
    EXPECT_NEAR(pops.p99_linear, 0.01 * 0.25, 1e-12);  // 197.01 is rounded
}

TEST(PopMeter, ComparesWhereTheObjectIsInEitherFrame) {
    Mask left(16, 0);
    Mask right(16, 0);
    left[0] = right[3] = 1;
    PopMeter meter{0.1};
    meter.add(k_grey, k_grey, left);
    meter.add(k_grey, with(k_grey, 3, 0, k_white), right);
    EXPECT_DOUBLE_EQ(meter.result().max_linear, 0.25);  // one of two pixels by 0.5
}

TEST(PopMeter, DoesNotCountTheReferencesOwnChange) {
    PopMeter meter{1.0 / 60.0};
    for (std::uint32_t i = 0; i < 20; ++i)
        meter.add(noise(4, 4, i), noise(4, 4, i), k_everywhere);
    EXPECT_EQ(meter.result().max_linear, 0.0);
    EXPECT_EQ(meter.result().in_100ms_linear, 0.0);
}

TEST(PopMeter, OfNoFramesIsZeroAndNoTimeIsRefused) {
    EXPECT_EQ(PopMeter{0.016}.result().max_linear, 0.0);
    for (const double frame_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(PopMeter{frame_s}, std::invalid_argument);
}

TEST(PopMeter, RefusesFramesOfAnotherSize) {
    PopMeter meter{0.016};
    meter.add(k_grey, k_grey, k_everywhere);
    EXPECT_THROW(meter.add(filled(2, 8, k_black), filled(2, 8, k_black), k_everywhere),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rambla::game::study
