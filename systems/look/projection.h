#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace rambla::systems {

/// Perspective projection with reversed Z and no far plane: depth = near / −z_eye, 1 at the near plane, 0 at
/// infinity.
/// @param vertical_fov_rad  in (0, π)
/// @param aspect            width / height, > 0
/// @param near_m            > 0
[[nodiscard]] inline glm::mat4 reversed_perspective(float vertical_fov_rad, float aspect, float near_m) {
    const float focal = 1.0f / std::tan(0.5f * vertical_fov_rad);
    glm::mat4 clip_from_view{0.0f};
    clip_from_view[0][0] = focal / aspect;
    clip_from_view[1][1] = focal;
    clip_from_view[2][3] = -1.0f;
    clip_from_view[3][2] = near_m;
    return clip_from_view;
}

/// Orthographic projection with reversed Z: depth falls linearly from 1 at near_m to 0 at far_m before the
/// eye.
/// @param half_width_m, half_height_m  > 0
/// @param near_m, far_m                near_m < far_m
[[nodiscard]] inline glm::mat4 reversed_orthographic(float half_width_m, float half_height_m, float near_m,
                                                     float far_m) {
    glm::mat4 clip_from_view{1.0f};
    clip_from_view[0][0] = 1.0f / half_width_m;
    clip_from_view[1][1] = 1.0f / half_height_m;
    clip_from_view[2][2] = 1.0f / (far_m - near_m);
    clip_from_view[3][2] = far_m / (far_m - near_m);
    return clip_from_view;
}

}  // namespace rambla::systems
