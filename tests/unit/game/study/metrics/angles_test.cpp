#include "game/study/metrics/angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace rambla::game::study {
namespace {

constexpr double k_pi = std::numbers::pi;

TEST(Angles, OfParallelAndOppositeAndUprightDirections) {
    EXPECT_EQ(angle_rad({1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}), 0.0);
    EXPECT_DOUBLE_EQ(angle_rad({1.0, 0.0, 0.0}, {0.0, 0.0, 7.0}), k_pi / 2.0);
    EXPECT_DOUBLE_EQ(angle_rad({0.0, 1.0, 0.0}, {0.0, -0.1, 0.0}), k_pi);
}

TEST(Angles, OfTinyAngleKeepsItsDigits) {
    // The cosine of 1e-7 is 1 − 5e-15, of 1e-12 it is 1: acos would have two digits left or none.
    for (const double angle : {1e-3, 1e-7, 1e-12}) {
        const glm::dvec3 turned{std::cos(angle), std::sin(angle), 0.0};
        EXPECT_NEAR(angle_rad({1.0, 0.0, 0.0}, turned) / angle, 1.0, 1e-15);
        EXPECT_NEAR((k_pi - angle_rad({-1.0, 0.0, 0.0}, turned)) / angle, 1.0, 4.5e-16 / angle);  // ulp of π
    }
}

TEST(Angles, OfFloatsThatDifferInTheirLastDigits) {
    const std::vector<glm::vec3> reference(3, glm::vec3{1.0f, 0.0f, 0.0f});
    const std::vector<glm::vec3> test(3, glm::vec3{1.0f, 1e-7f, 0.0f});
    // 1e-7 as a float is off by up to 6e-8 of it.
    EXPECT_NEAR(angles_between(reference, test).p50_deg / (1e-7 * 180.0 / k_pi), 1.0, 1e-7);
}

TEST(Angles, PercentilesAreThoseOfTheAngles) {
    std::vector<glm::vec3> reference;
    std::vector<glm::vec3> test;
    for (int degrees = 0; degrees <= 100; ++degrees) {
        const double angle = degrees * k_pi / 180.0;
        reference.emplace_back(3.0f, 0.0f, 0.0f);
        test.emplace_back(static_cast<float>(std::cos(angle)), 0.0f, static_cast<float>(std::sin(angle)));
    }
    const Angles angles = angles_between(reference, test);
    // Components rounded to floats turn a direction by 6e-8 rad = 3.4e-6 degrees at most.
    EXPECT_NEAR(angles.p50_deg, 50.0, 4e-6);
    EXPECT_NEAR(angles.p99_deg, 99.0, 4e-6);
    EXPECT_NEAR(angles.max_deg, 100.0, 4e-6);
    EXPECT_EQ(angles.counted, 101u);
    EXPECT_EQ(angles.not_counted, 0u);
}

TEST(Angles, DoNotCountWhatIsNoDirection) {
    constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    const glm::vec3 up{0.0f, 1.0f, 0.0f};
    const std::vector<glm::vec3> reference{up, up, glm::vec3{0.0f}, up, {k_nan, 0.0f, 0.0f}};
    const std::vector<glm::vec3> test{{1.0f, 0.0f, 0.0f}, glm::vec3{0.0f}, up, {k_infinity, 0.0f, 0.0f}, up};
    const Angles angles = angles_between(reference, test);
    EXPECT_EQ(angles.counted, 1u);
    EXPECT_EQ(angles.not_counted, 4u);
    EXPECT_DOUBLE_EQ(angles.p50_deg, 90.0);
    EXPECT_DOUBLE_EQ(angles.p99_deg, 90.0);
}

TEST(Angles, OfNothingAreZero) {
    const Angles angles = angles_between({}, {});
    EXPECT_EQ(angles.p50_deg, 0.0);
    EXPECT_EQ(angles.p99_deg, 0.0);
    EXPECT_EQ(angles.counted, 0u);
}

TEST(Angles, OfTheShortestAndLongestVectors) {
    constexpr float k_max = std::numeric_limits<float>::max();
    constexpr float k_min = std::numeric_limits<float>::denorm_min();
    const std::vector<glm::vec3> reference{{k_max, 0.0f, 0.0f}, {k_min, 0.0f, 0.0f}};
    const std::vector<glm::vec3> test{{k_max, k_max, 0.0f}, {k_min, k_min, 0.0f}};
    const Angles angles = angles_between(reference, test);
    EXPECT_EQ(angles.counted, 2u);
    EXPECT_DOUBLE_EQ(angles.p50_deg, 45.0);
    EXPECT_DOUBLE_EQ(angles.max_deg, 45.0);
}

TEST(Angles, SeeOneChangedPixel) {
    const std::vector<glm::vec3> reference(1000, glm::vec3{0.0f, 0.0f, 1.0f});
    std::vector<glm::vec3> test = reference;
    test[77] = {0.0f, 1.0f, 0.0f};
    EXPECT_EQ(angles_between(reference, test).p99_deg, 0.0);
    EXPECT_DOUBLE_EQ(angles_between(reference, test).max_deg, 90.0);
}

TEST(Angles, RefuseUnequalCounts) {
    const std::vector<glm::vec3> one(1), two(2);
    EXPECT_THROW(static_cast<void>(angles_between(one, two)), std::invalid_argument);
}

}  // namespace
}  // namespace rambla::game::study
