#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "assets/clip.h"

namespace rambla::systems {

/// Values of animation channels between their keys. Additions, multiplications, divisions and square roots of
/// doubles only, so that every compiler and C library gives the same bits.

/// Where a time falls between the keys of a channel.
struct KeySpan {
    std::uint32_t left = 0;   ///< key at or before the time; the first one before all keys
    std::uint32_t right = 0;  ///< the next key; `left` itself before the first and from the last key on
    double share = 0.0;       ///< [0, 1) of the way from left to right
    double length_s = 0.0;    ///< from left to right
};

/// @param times_s  ascending, at least one; of equal ones the last counts from its time on
/// @param time_s   any; NaN falls on the first key
/// @param hint     the answer for a time shortly before makes this one quick; gets `left`. Any number will do
///                 and changes nothing else.
[[nodiscard]] KeySpan find_keys(std::span<const float> times_s, double time_s, std::uint32_t& hint);

/// The rotation a share of the way from `a` to `b`, along the shorter arc at constant angular speed, of unit
/// length. Between exactly opposite rotations (half a turn apart) any of the equally short arcs will do; the
/// one through the sum of the quaternions is taken.
/// @param a, b   unit quaternions; q and −q are the same rotation
/// @param share  in [0, 1]
/// Shoemake 1985, "Animating rotation with quaternion curves"; sines by the series in cos θ − 1 of Eberly
/// 2011, "A fast and accurate algorithm for computing SLERP", eq. 6, over half of the arc: nine terms leave
/// less than 1e-8.
[[nodiscard]] glm::quat mixed_rotation(const glm::quat& a, const glm::quat& b, double share);

/// One float of a channel's value at a time; held before the first key and after the last.
/// @param component  < channel.width
/// glTF 2.0, appendix C. What the curve makes infinite or NaN is the value of the key before.
[[nodiscard]] float sample_component(const assets::Channel& channel, std::uint32_t component, double time_s,
                                     std::uint32_t& hint);
/// As above, of a channel of width 3.
[[nodiscard]] glm::vec3 sample_vector(const assets::Channel& channel, double time_s, std::uint32_t& hint);
/// As above, of a channel of rotations: a unit quaternion. A spline that passes through zero, where it has no
/// direction, is the key before.
[[nodiscard]] glm::quat sample_rotation(const assets::Channel& channel, double time_s, std::uint32_t& hint);

/// A playing time brought back to the clip: when looping, times beyond the ends enter again at the other end
/// (the end itself stays, so that it can be looked at); else they are held there. NaN is the beginning, and
/// so are the infinities of a loop.
/// @param duration_s  ≥ 0; a clip of no length has no time but 0
[[nodiscard]] double time_in_clip(double time_s, double duration_s, bool looping);

}  // namespace rambla::systems
