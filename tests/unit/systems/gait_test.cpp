#include "systems/simulate/gait.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "systems/simulate/trigonometry.h"

namespace rambla::systems {
namespace {

constexpr float k_step = 1.0f / 60.0f;

/// Where the sole of a leg without shin is, relative to the place on the ground that the walker stands on.
glm::vec3 sole_m(const Gait& gait, bool right) {
    const glm::quat hip = limb_rotation({{}, LimbRole::leg, right, {1, 0, 0, 0}}, gait);
    const float hip_height = gait.leg_length_m - pelvis_drop_m(gait);
    return glm::vec3{0.0f, hip_height, 0.0f} + hip * glm::vec3{0.0f, -gait.leg_length_m, 0.0f};
}

TEST(Gait, AStandingFootNeitherSlidesNorLeavesTheGround) {
    for (const float speed : {0.4f, 1.0f, 1.3f, 1.8f}) {
        Gait gait{.leg_length_m = 0.87f, .phase = 0.2f, .reach = 0.0f};
        gait = advanced(gait, speed, 0.0f, 1.0f);
        float travelled = 0.0f;
        float planted = 0.0f;
        bool stood_right = gait.phase >= 0.5f;
        int standing_steps = 0;
        for (int i = 0; i < 600; ++i) {
            gait = advanced(gait, speed, speed * k_step, 1.0f);
            travelled += speed * k_step;
            const bool right = gait.phase >= 0.5f;  // the foot that stands
            const bool new_foot = i == 0 || std::exchange(stood_right, right) != right;
            const glm::vec3 sole = sole_m(gait, right);
            ASSERT_NEAR(sole.y, 0.0f, 1e-5f) << "on the ground";
            const float place = travelled + k_forward_z * sole.z;
            if (new_foot) {
                planted = place;
                continue;
            }
            // Rounding alone: places of some ten metres have steps of 1e-6 m, and dozens of them add up.
            ASSERT_NEAR(place, planted, 1e-4f) << "at " << speed << " m/s, phase " << gait.phase;
            ++standing_steps;
        }
        EXPECT_GT(standing_steps, 500);
    }
}

TEST(Gait, LegsMoveSmoothly) {
    Gait gait{.leg_length_m = 0.9f, .phase = 0.0f, .reach = 0.0f};
    gait = advanced(gait, 1.3f, 0.0f, 1.0f);
    glm::quat last = limb_rotation({{}, LimbRole::leg, false, {1, 0, 0, 0}}, gait);
    double last_speed = 0.0;
    for (int i = 1; i < 4000; ++i) {
        gait.phase = static_cast<float>(i % 1000) / 1000.0f;
        const glm::quat now = limb_rotation({{}, LimbRole::leg, false, {1, 0, 0, 0}}, gait);
        const double speed = static_cast<double>(now.x - last.x) * 1000.0;  // per cycle
        // A cubic's second derivative bounds the change of speed: 24 · reach / 2 per cycle² at the ends of a
        // swing.
        if (i > 1) {
            ASSERT_NEAR(speed, last_speed, 0.06) << "phase " << gait.phase;
        }
        last = now;
        last_speed = speed;
    }
}

TEST(Gait, AmplitudeFollowsSpeed) {
    const Gait rest{};
    const float slow = advanced(rest, 0.3f, 0.01f, 1.0f).reach;
    const float walk = advanced(rest, 1.3f, 0.01f, 1.0f).reach;
    EXPECT_EQ(advanced(rest, 0.0f, 0.0f, 1.0f).reach, 0.0f);
    EXPECT_GT(slow, 0.0f);
    EXPECT_GT(walk, 1.5f * slow);
    EXPECT_LE(advanced(rest, 100.0f, 1.0f, 1.0f).reach, 0.6f + 1e-6f);
    EXPECT_FLOAT_EQ(pelvis_drop_m(rest), 0.0f);
}

TEST(Gait, LimbsBendTheRightWay) {
    Gait gait{.leg_length_m = 0.9f, .phase = 0.0f, .reach = 0.4f};
    const auto ahead = [&](LimbRole role, bool right, float phase) {
        gait.phase = phase;
        return k_forward_z *
               (limb_rotation({{}, role, right, {1, 0, 0, 0}}, gait) * glm::vec3{0.0f, -1.0f, 0.0f}).z;
    };
    EXPECT_NEAR(ahead(LimbRole::leg, false, 0.0f), 0.4f, 1e-5f) << "the left foot lands in front";
    EXPECT_NEAR(ahead(LimbRole::leg, true, 0.0f), -0.4f, 1e-5f) << "while the right one is behind";
    EXPECT_LT(ahead(LimbRole::arm, false, 0.0f), -0.1f) << "the left arm is back then";
    EXPECT_GT(ahead(LimbRole::arm, true, 0.0f), 0.1f);
    EXPECT_LT(ahead(LimbRole::shin, false, 0.75f), -0.5f) << "knees bend backwards";
    EXPECT_FLOAT_EQ(ahead(LimbRole::shin, false, 0.25f), 0.0f) << "a standing leg is straight";
    EXPECT_GT(ahead(LimbRole::forearm, false, 0.5f), 0.1f) << "elbows bend forwards";
}

TEST(Wheels, RollWithoutSlipping) {
    const WheelSpin wheel{{}, 0.32f, {1, 0, 0, 0}};
    // A quarter of the circumference brings the foremost point of the tread to the ground.
    const double quarter = 0.5 * k_pi * 0.32;
    const glm::vec3 front = wheel_rotation(wheel, quarter) * glm::vec3{0.0f, 0.0f, k_forward_z};
    EXPECT_NEAR(front.y, -1.0f, 1e-6f);
    const glm::vec3 after =
        wheel_rotation(wheel, quarter + 1000.0 * 4.0 * quarter) * glm::vec3{0.0f, 0.0f, k_forward_z};
    EXPECT_NEAR(after.y, -1.0f, 1e-4f) << "also after a thousand turns";
}

TEST(Facing, TurnsTheModelsForwardAxisIntoTheHeading) {
    for (int i = 0; i < 3600; ++i) {
        const double angle = 2.0 * k_pi * i / 3600.0;
        const glm::vec2 heading{std::sin(angle), std::cos(angle)};
        const glm::quat rotation = facing(heading);
        const glm::vec3 forward = rotation * glm::vec3{0.0f, 0.0f, k_forward_z};
        ASSERT_NEAR(forward.x, heading.x, 1e-6f);
        ASSERT_NEAR(forward.z, heading.y, 1e-6f);
        ASSERT_NEAR(glm::length(rotation), 1.0f, 1e-6f);
    }
}

TEST(Trigonometry, AgreesWithTheLibraryWithinItsStatedError) {
    for (int i = -200000; i <= 200000; ++i) {
        const double angle = i * 0.0123456789;
        ASSERT_NEAR(sine(angle), std::sin(angle), 1e-11);
        ASSERT_NEAR(cosine(angle), std::cos(angle), 1e-11);
    }
    EXPECT_NEAR(sine(999999.25), std::sin(999999.25), 1e-9);
    EXPECT_EQ(sine(0.0), 0.0);
    EXPECT_EQ(cosine(0.0), 1.0);
}

}  // namespace
}  // namespace rambla::systems
