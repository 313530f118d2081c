#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "assets/place.h"

namespace rambla::game {

/// Where a scripted camera stands, in metres from the place's origin.
struct CameraPose {
    glm::vec3 eye_m{0.0f};
    glm::vec3 target_m{0.0f, 0.0f, -1.0f};
};

/// Time of the last key; 0 for an empty path.
[[nodiscard]] float duration_s(std::span<const assets::CameraKey> keys);

/// Pose on a path of at least one key: passes through every key at its time, with continuous velocity between
/// them. Times outside the path stand still at its ends. Cubic Hermite over the keys' own times; the tangent
/// at a key is that of the parabola through it and its neighbours (Bessel tangents; Catmull-Rom's where keys
/// are evenly spaced).
[[nodiscard]] CameraPose pose_at(std::span<const assets::CameraKey> keys, float time_s);

/// Rotation of a camera at `eye` that looks at `target` with +Y up; a look straight up or down keeps −Z as
/// "up".
[[nodiscard]] glm::quat look_rotation(glm::vec3 eye, glm::vec3 target);

}  // namespace rambla::game
