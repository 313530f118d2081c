#include "systems/simulate/sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace rambla::systems {
namespace {

using assets::AnimatedPath;
using assets::Channel;
using assets::Interpolation;

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr float k_max = std::numeric_limits<float>::max();
constexpr std::array k_times{-k_infinity, -1e300, -1e9, -1.0, -0.0,  1e-300,     0.5,
                             1.0,         1.5,    2.0,  1e9,  1e300, k_infinity, k_nan};
constexpr std::array k_kinds{Interpolation::step, Interpolation::linear, Interpolation::cubic_spline};

Channel channel(AnimatedPath path, Interpolation kind, std::uint32_t width, std::vector<float> times,
                std::vector<float> values) {
    return {0, path, kind, width, std::move(times), std::move(values)};
}

bool is_unit(const glm::quat& q) {
    const glm::dquat exact{q};
    return std::fabs(std::sqrt(glm::dot(exact, exact)) - 1.0) < 1e-6;
}

TEST(SamplingStability, OneKeyIsTheValueAtAnyTime) {
    for (const Interpolation kind : k_kinds) {
        std::vector<float> values{1, 2, 3};
        if (kind == Interpolation::cubic_spline) values = {k_max, k_max, k_max, 1, 2, 3, k_max, k_max, k_max};
        const Channel c = channel(AnimatedPath::translation, kind, 3, {1}, values);
        for (const double t : k_times) {
            std::uint32_t hint = 7;
            EXPECT_EQ(sample_vector(c, t, hint), glm::vec3(1, 2, 3)) << t;
        }
    }
}

TEST(SamplingStability, DuplicateKeysJumpWithoutDivision) {
    // A key repeated thrice: the last of them counts from its time on.
    const Channel c = channel(AnimatedPath::translation, Interpolation::linear, 3, {0, 1, 1, 1, 2},
                              {0, 0, 0, 1, 1, 1, 5, 5, 5, 9, 9, 9, 10, 10, 10});
    std::uint32_t hint = 0;
    EXPECT_NEAR(sample_vector(c, 1.0 - 1e-9, hint).x, 1.0f, 1e-6f);
    EXPECT_EQ(sample_vector(c, 1.0, hint).x, 9.0f);
    EXPECT_EQ(sample_vector(c, 1.5, hint).x, 9.5f);
    const Channel same = channel(AnimatedPath::translation, Interpolation::cubic_spline, 3, {1, 1},
                                 std::vector<float>(18, 2.0f));
    for (const double t : k_times) {
        EXPECT_EQ(sample_vector(same, t, hint), glm::vec3(2.0f)) << t;
    }
}

TEST(SamplingStability, UnsortedKeysGiveFiniteValuesOfTheChannel) {
    const Channel c =
        channel(AnimatedPath::translation, Interpolation::linear, 3, {2, 0, 1}, {1, 1, 1, 2, 2, 2, 3, 3, 3});
    for (const double t : k_times) {
        std::uint32_t hint = 0;
        const float x = sample_vector(c, t, hint).x;
        EXPECT_TRUE(x >= 1.0f && x <= 3.0f) << t << " gave " << x;
    }
}

TEST(SamplingStability, OppositeQuaternionsAreOneRotation) {
    const glm::quat q = glm::angleAxis(1.0f, glm::normalize(glm::vec3{1, 2, 3}));
    for (double share = 0.0; share <= 1.0; share += 0.125) {
        const glm::quat found = mixed_rotation(q, -q, share);
        EXPECT_GT(std::fabs(glm::dot(found, q)), 1.0f - 1e-6f) << share;
        EXPECT_TRUE(is_unit(found));
    }
}

TEST(SamplingStability, HalfATurnGoesTheWholeWayAtEvenSpeed) {
    // Quaternions at right angles: rotations as far apart as rotations can be.
    for (const glm::quat& b :
         {glm::quat{0, 0, 1, 0}, glm::quat{-0.0f, 0, -1, 0}, glm::quat{1e-9f, 0, 1, 0}}) {
        for (double share = 0.0; share <= 1.0; share += 0.0625) {
            const glm::quat found = mixed_rotation({1, 0, 0, 0}, b, share);
            EXPECT_TRUE(is_unit(found)) << share;
            const double turned = 2.0 * std::acos(std::min(1.0, std::fabs(static_cast<double>(found.w))));
            EXPECT_NEAR(turned, share * 3.14159265358979, 2e-3) << "acos of a float near 1 is that coarse";
            EXPECT_EQ(found.x, 0.0f);
        }
    }
}

TEST(SamplingStability, RotationsWithoutDirectionAreNone) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Channel c = channel(AnimatedPath::rotation, Interpolation::linear, 4, {0, 1, 2, 3},
                              {0, 0, 0, 0, k_max, k_max, -k_max, k_max, 1e-40f, 0, 0, 0, nan, 0, 0, 1});
    for (const double t : k_times) {
        std::uint32_t hint = 0;
        EXPECT_TRUE(is_unit(sample_rotation(c, t, hint))) << t;
    }
    // A spline from q to −q passes through zero.
    const Channel through =
        channel(AnimatedPath::rotation, Interpolation::cubic_spline, 4, {0, 1},
                {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0});
    std::uint32_t hint = 0;
    EXPECT_EQ(sample_rotation(through, 0.5, hint), glm::quat(1, 0, 0, 0)) << "the key before";
    EXPECT_TRUE(is_unit(sample_rotation(through, 0.49999999, hint)));
}

TEST(SamplingStability, SplinesMayOvershootButStayFinite) {
    const Channel wide = channel(AnimatedPath::translation, Interpolation::cubic_spline, 3, {0, 1},
                                 {0, 0, 0, 0, 0, 0, 12, 12, 12, -12, -12, -12, 0, 0, 0, 0, 0, 0});
    std::uint32_t hint = 0;
    EXPECT_NEAR(sample_vector(wide, 0.5, hint).x, 3.0f, 1e-6f) << "beyond both keys, as the curve says";
    const Channel huge =
        channel(AnimatedPath::translation, Interpolation::cubic_spline, 3, {0, 1e30f},
                {0, 0, 0, 1, 2, 3, k_max, k_max, k_max, k_max, k_max, k_max, 4, 5, 6, 0, 0, 0});
    EXPECT_EQ(sample_vector(huge, 3e29, hint), glm::vec3(1, 2, 3)) << "what is infinite is the key before";
    const Channel turning = channel(AnimatedPath::rotation, Interpolation::cubic_spline, 4, {0, 1},
                                    {0,     0,     0,     0,     0, 0, 0, 1, k_max, k_max, k_max, k_max,
                                     k_max, k_max, k_max, k_max, 0, 1, 0, 0, 0,     0,     0,     0});
    for (double t = 0.0; t <= 1.0; t += 0.01)
        EXPECT_TRUE(is_unit(sample_rotation(turning, t, hint))) << t;
}

TEST(SamplingStability, AnyTimeFallsIntoTheClip) {
    for (const double duration : {0.0, -1.0, k_nan, 1e-30, 1.0, 1e30}) {
        for (const double t : k_times) {
            for (const bool looping : {false, true}) {
                const double found = time_in_clip(t, duration, looping);
                EXPECT_TRUE(found >= 0.0 && found <= std::fmax(duration, 0.0))
                    << t << " of " << duration << " became " << found;
            }
        }
    }
    EXPECT_EQ(time_in_clip(k_infinity, 2.0, false), 2.0);
    EXPECT_EQ(time_in_clip(-k_infinity, 2.0, false), 0.0);
}

}  // namespace
}  // namespace rambla::systems
