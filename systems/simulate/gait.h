#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "systems/components.h"

namespace rambla::systems {

/// How people walk, from the ground up: a standing foot does not slide, so it moves back under the body as
/// fast as the body moves on. With a straight leg of length L the hip's angle θ follows from the foot's place
/// x: sin θ = x / L; and the hip is only L · cos θ above the ground, which is the bob of the pelvis.
///
///        hip ──►             hip ──►          one foot stands during [0, ½) of a cycle, the other during [½,
///        1);
///       ╱│                    │╲              in the other half a foot swings forward with its knee bent.
///    L ╱ │ L cos θ            │ ╲ L
///     ╱θ │                    │θ ╲
///   ─●───┴──────          ────┴───●──
///    x = −reach · L             x = +reach · L

/// Models face −Z, like everything here that looks somewhere.
inline constexpr float k_forward_z = -1.0f;

/// How far one cycle (two steps) carries somebody who walks at this speed; slow walkers take short steps.
/// @param leg_m  leg length, > 0
[[nodiscard]] float cycle_length_m(float speed_m_s, float leg_m);

/// The gait after walking `distance_m` at `speed_m_s`.
/// @param scale  world size of the walker's own unit
[[nodiscard]] Gait advanced(const Gait& gait, float speed_m_s, float distance_m, float scale);

/// How far the pelvis is below its height at rest, in the walker's own units.
[[nodiscard]] float pelvis_drop_m(const Gait& gait);

/// Rotation of a part of the walker, relative to its parent.
[[nodiscard]] glm::quat limb_rotation(const GaitLimb& limb, const Gait& gait);

/// Rotation of a wheel whose car has travelled this far.
[[nodiscard]] glm::quat wheel_rotation(const WheelSpin& wheel, double travelled_m);

/// Rotation about Y that turns a model towards a heading.
/// @param heading  unit vector (x, z)
[[nodiscard]] glm::quat facing(glm::vec2 heading);

}  // namespace rambla::systems
