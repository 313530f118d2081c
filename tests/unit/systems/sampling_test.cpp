#include "systems/simulate/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace rambla::systems {
namespace {

using assets::AnimatedPath;
using assets::Channel;
using assets::Interpolation;

Channel channel(AnimatedPath path, Interpolation interpolation, std::uint32_t width, std::vector<float> times,
                std::vector<float> values) {
    return {0, path, interpolation, width, std::move(times), std::move(values)};
}

glm::dquat random_rotation(std::mt19937& engine) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dquat{normal(engine), normal(engine), normal(engine), normal(engine)});
}

/// The textbook formula, in double precision. Shoemake 1985.
glm::dquat slerp(glm::dquat a, glm::dquat b, double t) {
    a = glm::normalize(a);
    b = glm::normalize(glm::dot(a, b) < 0.0 ? -b : b);
    const glm::dquat apart = a - b, along = a + b;
    const double angle =
        2.0 * std::atan2(std::sqrt(glm::dot(apart, apart)), std::sqrt(glm::dot(along, along)));
    if (angle < 1e-12) return a;
    return (std::sin((1.0 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

double distance(const glm::dquat& a, const glm::dquat& b) {
    return std::sqrt(glm::dot(a - b, a - b));
}

TEST(Sampling, StepHoldsEachKeyUntilTheNext) {
    const Channel c =
        channel(AnimatedPath::translation, Interpolation::step, 3, {1, 2, 4}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    std::uint32_t hint = 0;
    EXPECT_EQ(sample_vector(c, 0.0, hint), glm::vec3(1, 2, 3)) << "before the first key";
    EXPECT_EQ(sample_vector(c, 1.999, hint), glm::vec3(1, 2, 3));
    EXPECT_EQ(sample_vector(c, 2.0, hint), glm::vec3(4, 5, 6));
    EXPECT_EQ(sample_vector(c, 3.999, hint), glm::vec3(4, 5, 6));
    EXPECT_EQ(sample_vector(c, 9.0, hint), glm::vec3(7, 8, 9)) << "after the last";
}

TEST(Sampling, LinearIsTheStraightLine) {
    const Channel c =
        channel(AnimatedPath::scale, Interpolation::linear, 3, {0.5f, 2}, {1, -2, 3e5f, 4, 5, -6});
    std::uint32_t hint = 0;
    for (double t = 0.5; t <= 2.0; t += 0.01) {
        const double share = (t - 0.5) / 1.5;
        const glm::vec3 found = sample_vector(c, t, hint);
        EXPECT_EQ(found.x, static_cast<float>(1 + 3 * share));
        EXPECT_EQ(found.y, static_cast<float>(-2 * (1 - share) + 5 * share));
        EXPECT_NEAR(found.z, 3e5 + (-6 - 3e5) * share, 0.02) << "half a step of a float";
    }
}

TEST(Sampling, CubicSplinesFollowHermite) {
    // in-tangent, value, out-tangent of each key
    const Channel c = channel(AnimatedPath::weights, Interpolation::cubic_spline, 2, {1, 3, 3.5f},
                              {9, 9, 0.5f, 1, 2, -3, -1, 4, 2, 0, 5, 1, 0, -2, 1, 1, 9, 9});
    const auto hermite = [](double p0, double m0, double p1, double m1, double length, double t) {
        return (2 * t * t * t - 3 * t * t + 1) * p0 + length * (t * t * t - 2 * t * t + t) * m0 +
               (-2 * t * t * t + 3 * t * t) * p1 + length * (t * t * t - t * t) * m1;
    };
    std::uint32_t hint = 0;
    for (double t = 0.0; t < 1.0; t += 0.01) {
        EXPECT_NEAR(sample_component(c, 0, 1 + 2 * t, hint), hermite(0.5, 2, 2, -1, 2, t), 2e-7);
        EXPECT_NEAR(sample_component(c, 1, 1 + 2 * t, hint), hermite(1, -3, 0, 4, 2, t), 2e-7);
        EXPECT_NEAR(sample_component(c, 0, 3 + 0.5 * t, hint), hermite(2, 5, 1, 0, 0.5, t), 2e-7);
    }
    EXPECT_EQ(sample_component(c, 0, 0.0, hint), 0.5f);
    EXPECT_EQ(sample_component(c, 1, 8.0, hint), 1.0f);
}

TEST(Sampling, RotationsTurnEvenlyAlongTheShorterArc) {
    std::mt19937 engine{1};
    std::uniform_real_distribution<double> unit{0.0, 1.0};
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const glm::quat a{random_rotation(engine)};
        glm::quat b{random_rotation(engine)};
        if (i % 4 == 0) b = glm::normalize(a + 1e-4f * b);  // almost the same
        const double t = i % 7 == 0 ? 1.0 : unit(engine);
        const glm::dquat found{mixed_rotation(a, b, t)};
        // Both ends were rounded to floats; the found one once more.
        worst = std::max(worst, distance(found, slerp(glm::dquat{a}, glm::dquat{b}, t)));
    }
    EXPECT_LT(worst, 2e-7);
}

TEST(Sampling, RotationChannelsInterpolateAsTheirKindSays) {
    std::mt19937 engine{2};
    const glm::quat a{random_rotation(engine)}, b{random_rotation(engine)};
    const std::vector<float> linear{a.x, a.y, a.z, a.w, -b.x, -b.y, -b.z, -b.w};
    const Channel c = channel(AnimatedPath::rotation, Interpolation::linear, 4, {0, 2}, linear);
    std::uint32_t hint = 0;
    EXPECT_LT(distance(glm::dquat{sample_rotation(c, 0.6, hint)}, slerp(glm::dquat{a}, glm::dquat{b}, 0.3)),
              2e-7);

    std::vector<float> spline{0, 0, 0, 0};
    spline.insert(spline.end(), {a.x, a.y, a.z, a.w, 0.5f, -0.2f, 0.1f, 0.4f, -0.3f, 0.2f, 0.7f, 0.1f});
    spline.insert(spline.end(), {b.x, b.y, b.z, b.w, 0, 0, 0, 0});
    const Channel curve = channel(AnimatedPath::rotation, Interpolation::cubic_spline, 4, {0, 2}, spline);
    const double t = 0.3, t2 = t * t, t3 = t2 * t;
    const glm::dquat out{0.4, 0.5, -0.2, 0.1}, in{0.1, -0.3, 0.2, 0.7};
    const glm::dquat exact =
        glm::normalize((2 * t3 - 3 * t2 + 1) * glm::dquat{a} + 2 * (t3 - 2 * t2 + t) * out +
                       (3 * t2 - 2 * t3) * glm::dquat{b} + 2 * (t3 - t2) * in);
    EXPECT_LT(distance(glm::dquat{sample_rotation(curve, 0.6, hint)}, exact), 2e-7);
}

TEST(Sampling, AnyHintGivesTheSameAnswer) {
    std::mt19937 engine{3};
    std::vector<float> times{0.25f};
    std::uniform_real_distribution<float> gap{0.001f, 0.3f};
    while (times.size() < 200)
        times.push_back(times.back() + gap(engine));
    std::uniform_real_distribution<double> anywhere{-1.0, static_cast<double>(times.back()) + 1.0};
    for (int i = 0; i < 20000; ++i) {
        // Exactly on a key every third time.
        const double t = i % 3 == 0 ? static_cast<double>(times[engine() % 200]) : anywhere(engine);
        std::uint32_t hint = i % 5 == 0 ? 0xffffffffu : engine() % 210;
        const KeySpan found = find_keys(times, t, hint);
        EXPECT_EQ(hint, found.left);
        std::uint32_t expected = 0;
        while (expected + 1 < 200 && static_cast<double>(times[expected + 1]) <= t)
            ++expected;
        ASSERT_EQ(found.left, expected) << t;
        const bool inside = t > static_cast<double>(times[0]) && expected + 1 < 200;
        ASSERT_EQ(found.right, inside && t != static_cast<double>(times[expected]) ? expected + 1 : expected);
        ASSERT_TRUE(found.share >= 0.0 && found.share < 1.0);
    }
}

TEST(Sampling, LoopsEnterAtTheOtherEndAndOthersHold) {
    EXPECT_EQ(time_in_clip(0.75, 2.0, true), 0.75);
    EXPECT_EQ(time_in_clip(2.0, 2.0, true), 2.0) << "the end can be looked at";
    EXPECT_EQ(time_in_clip(2.5, 2.0, true), 0.5);
    EXPECT_EQ(time_in_clip(7.0, 2.0, true), 1.0);
    EXPECT_EQ(time_in_clip(-0.5, 2.0, true), 1.5);
    EXPECT_EQ(time_in_clip(-4.5, 2.0, true), 1.5);
    EXPECT_EQ(time_in_clip(2.5, 2.0, false), 2.0);
    EXPECT_EQ(time_in_clip(-0.5, 2.0, false), 0.0);
}

}  // namespace
}  // namespace rambla::systems
