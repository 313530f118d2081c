#include "systems/simulate/gait.h"

#include <algorithm>
#include <cmath>

#include "systems/simulate/trigonometry.h"

namespace rambla::systems {
namespace {

/// Largest reach of a step: hips open 37° to either side.
constexpr float k_max_reach = 0.6f;
/// Knee's bend in mid-swing and elbow's bend at rest and when the arm is in front, at full reach of a brisk
/// walk.
constexpr float k_knee_rad = 1.05f;
constexpr float k_elbow_rest_rad = 0.15f;
constexpr float k_elbow_swing_rad = 0.35f;
/// Arms swing less than legs; the shoulders turn a little against the hips.
constexpr float k_arm_share = 0.85f;
constexpr float k_torso_twist_rad = 0.12f;
constexpr float k_brisk_reach = 0.4f;

float wrapped(float phase) {
    return phase - std::floor(phase);
}

/// Phase of the limb's own side: 0 … ½ its foot stands, ½ … 1 it swings.
float side_phase(const Gait& gait, bool right) {
    return wrapped(gait.phase + (right ? 0.5f : 0.0f));
}

/// Sine of the hip's angle, forwards positive.
float hip_sine(float phase, float reach) {
    if (phase < 0.5f) return reach * (1.0f - 4.0f * phase);
    // Back to the front by a cubic Hermite curve from −1 to 1, whose slopes continue those of standing: −2
    // per swing.
    const float s = 2.0f * phase - 1.0f;
    const float s2 = s * s;
    const float s3 = s2 * s;
    const float place = 4.0f * s3 - 6.0f * s2 + 1.0f;  // 1 − 2·(3s² − 2s³): from 1 to −1
    const float slopes = 2.0f * s3 - 3.0f * s2 + s;    // both tangents' basis functions together
    return reach * (-place - 2.0f * slopes);
}

glm::quat about_x(double angle_rad) {
    return {static_cast<float>(cosine(0.5 * angle_rad)), static_cast<float>(sine(0.5 * angle_rad)), 0.0f,
            0.0f};
}

glm::quat about_y(double angle_rad) {
    return {static_cast<float>(cosine(0.5 * angle_rad)), 0.0f, static_cast<float>(sine(0.5 * angle_rad)),
            0.0f};
}

/// Rotation about X by the angle in (−π/2, π/2) with this sine, by the half-angle formulas: √ is exact
/// everywhere, asin is not.
glm::quat about_x_by_sine(float sine_of_angle) {
    const float cosine_of_angle = std::sqrt(1.0f - sine_of_angle * sine_of_angle);
    const float half_cosine = std::sqrt(0.5f + 0.5f * cosine_of_angle);
    return {half_cosine, sine_of_angle / (2.0f * half_cosine), 0.0f, 0.0f};
}

}  // namespace

float cycle_length_m(float speed_m_s, float leg_m) {
    // A fit to how people walk: about 1.4 m at 1.3 m/s with legs of 0.9 m, steps growing with speed; from
    // rest the steps grow from nothing.
    const float starting = std::min(speed_m_s / 0.5f, 1.0f);
    const float length = leg_m * (0.8f + 0.6f * speed_m_s) * starting;
    return std::min(length, 4.0f * k_max_reach * leg_m);
}

Gait advanced(const Gait& gait, float speed_m_s, float distance_m, float scale) {
    const float leg_m = gait.leg_length_m * scale;
    const float cycle_m = cycle_length_m(speed_m_s, leg_m);
    if (!(cycle_m > 0.0f)) return {gait.leg_length_m, gait.phase, 0.0f};
    return {gait.leg_length_m, wrapped(gait.phase + distance_m / cycle_m), cycle_m / (4.0f * leg_m)};
}

float pelvis_drop_m(const Gait& gait) {
    const bool left_stands = gait.phase < 0.5f;
    const float sine_of_angle = hip_sine(side_phase(gait, !left_stands), gait.reach);
    return gait.leg_length_m * (1.0f - std::sqrt(1.0f - sine_of_angle * sine_of_angle));
}

glm::quat limb_rotation(const GaitLimb& limb, const Gait& gait) {
    const float phase = side_phase(gait, limb.right);
    const float effort = std::min(gait.reach / k_brisk_reach, 1.0f);
    switch (limb.role) {
        // A leg hangs down −Y: a turn about X by θ lifts it towards −Z, by −θ towards +Z.
        case LimbRole::leg:
            return limb.rest * about_x_by_sine(-k_forward_z * hip_sine(phase, gait.reach));
        case LimbRole::shin: {
            if (phase < 0.5f) return limb.rest;
            const float s = 2.0f * phase - 1.0f;
            const float bump = 16.0f * s * s * (1.0f - s) * (1.0f - s);
            return limb.rest * about_x(static_cast<double>(k_forward_z * k_knee_rad * effort * bump));
        }
        // Arms go with the other side's leg: forwards while the leg of their side goes back.
        case LimbRole::arm: {
            const double swing = -cosine(2.0 * k_pi * static_cast<double>(phase));
            return limb.rest * about_x(-static_cast<double>(k_forward_z * k_arm_share * gait.reach) * swing);
        }
        case LimbRole::forearm: {
            const double front = 0.5 - 0.5 * cosine(2.0 * k_pi * static_cast<double>(phase));
            const double bend = static_cast<double>(k_elbow_rest_rad) +
                                static_cast<double>(k_elbow_swing_rad * effort) * front;
            return limb.rest * about_x(-static_cast<double>(k_forward_z) * bend);
        }
        case LimbRole::torso:
        case LimbRole::head: {
            const double against = limb.role == LimbRole::torso ? 1.0 : -1.0;
            const double twist = cosine(2.0 * k_pi * static_cast<double>(gait.phase));
            return limb.rest * about_y(against * static_cast<double>(k_torso_twist_rad * effort) * twist);
        }
    }
    return limb.rest;
}

glm::quat wheel_rotation(const WheelSpin& wheel, double travelled_m) {
    const double turns = travelled_m / (2.0 * k_pi * static_cast<double>(wheel.radius_m));
    const double angle = 2.0 * k_pi * (turns - std::floor(turns));
    return wheel.rest * about_x(static_cast<double>(k_forward_z) * angle);
}

glm::quat facing(glm::vec2 heading) {
    // Turning +Z by ψ about Y gives (sin ψ, 0, cos ψ), −Z the opposite. Of the half angle's sine and cosine
    // the larger is found first, so that nothing is divided by almost zero.
    const glm::vec2 h = heading * k_forward_z;
    const float largest = std::sqrt(0.5f + 0.5f * std::fabs(h.y));
    const float other = h.x / (2.0f * largest);
    return h.y >= 0.0f ? glm::quat{largest, 0.0f, other, 0.0f} : glm::quat{other, 0.0f, largest, 0.0f};
}

}  // namespace rambla::systems
