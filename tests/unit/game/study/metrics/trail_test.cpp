#include "game/study/metrics/trail.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "unit/game/study/metrics/pictures.h"

namespace rambla::game::study {
namespace {

using Mask = std::vector<std::uint8_t>;

constexpr std::uint32_t k_width = 12;
constexpr std::uint32_t k_frames = 12;
constexpr double k_tolerance = 0.01;

/// A white pixel that walks to the right over black, one pixel a frame.
Picture walker_at(std::uint32_t x) {
    return with(filled(k_width, 1, k_black), x, 0, k_white);
}
Mask mask_at(std::uint32_t x) {
    Mask mask(k_width, 0);
    mask[x] = 1;
    return mask;
}

/// What is left after so many frames: a share of the light of white.
template <class LeftAfter>
TrailMeter with_trail(LeftAfter&& left_after) {
    TrailMeter meter{8};
    for (std::uint32_t frame = 0; frame < k_frames; ++frame) {
        Picture test = walker_at(frame);
        for (std::uint32_t age = 1; age <= frame; ++age)
            test.at(frame - age, 0) = glm::vec3{left_after(age)};
        meter.add(walker_at(frame), walker_at(frame), test, mask_at(frame));
    }
    return meter;
}

TEST(Trail, OfEqualPicturesHasNoFrame) {
    const TrailMeter meter = with_trail([](std::uint32_t) { return 0.0f; });
    EXPECT_EQ(meter.excess_display(), std::vector<double>(8, 0.0));
    EXPECT_EQ(trail_frames(meter.excess_display(), k_tolerance), 0u);
    // A pixel is uncovered in every frame but the first; those 8 frames old have had 8 frames less.
    EXPECT_EQ(meter.pixels().front(), k_frames - 1u);
    EXPECT_EQ(meter.pixels().back(), k_frames - 8u);
}

TEST(Trail, IsAsLongAsItIsSeen) {
    for (const std::uint32_t length : {1u, 3u, 8u}) {
        const TrailMeter meter =
            with_trail([&](std::uint32_t age) { return age <= length ? 0.2140411f : 0.0f; });
        EXPECT_EQ(trail_frames(meter.excess_display(), k_tolerance), length);
        EXPECT_NEAR(meter.excess_display().front(), 0.5, 1e-6) << "the code of that light";
    }
}

TEST(Trail, EndsWhereItIsWithinTheTolerance) {
    // A linear ramp near black: code 12.92·light, 0.0646 after one frame, a half of it after each further
    // one.
    const TrailMeter meter =
        with_trail([](std::uint32_t age) { return 0.005f / static_cast<float>(1u << (age - 1)); });
    EXPECT_EQ(trail_frames(meter.excess_display(), 0.05), 1u);
    EXPECT_EQ(trail_frames(meter.excess_display(), 0.01), 3u) << "0.065, 0.032, 0.016 and 0.008";
}

TEST(Trail, OfErrorsThatAPictureWithoutHistoryHasTooIsNone) {
    TrailMeter meter{8};
    for (std::uint32_t frame = 0; frame < k_frames; ++frame) {
        Picture jagged = walker_at(frame);
        if (frame > 0) jagged.at(frame - 1, 0) = k_white;
        meter.add(walker_at(frame), jagged, jagged, mask_at(frame));
    }
    EXPECT_EQ(trail_frames(meter.excess_display(), k_tolerance), 0u);
}

TEST(Trail, DoesNotCountWhatNothingHasCovered) {
    TrailMeter meter{8};
    for (std::uint32_t frame = 0; frame < k_frames; ++frame)
        meter.add(filled(k_width, 1, k_black), filled(k_width, 1, k_black), filled(k_width, 1, k_white),
                  Mask(k_width, 0));
    EXPECT_EQ(meter.pixels(), std::vector<std::uint64_t>(8, 0));
    EXPECT_EQ(trail_frames(meter.excess_display(), k_tolerance), 0u);
}

TEST(Trail, BeginsAnewWhereSomethingElsePasses) {
    TrailMeter meter{8};
    const Picture black = filled(k_width, 1, k_black);
    for (std::uint32_t frame = 0; frame < 4; ++frame)
        meter.add(black, black, black, frame % 2 == 0 ? mask_at(5) : Mask(k_width, 0));
    EXPECT_EQ(meter.pixels(), (std::vector<std::uint64_t>{2, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(Trail, RefusesOtherSizes) {
    TrailMeter meter{8};
    const Picture black = filled(k_width, 1, k_black);
    EXPECT_THROW(meter.add(black, black, filled(2, 2, k_black), Mask(k_width, 0)), std::invalid_argument);
    EXPECT_THROW(meter.add(black, black, black, Mask(3, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace rambla::game::study
