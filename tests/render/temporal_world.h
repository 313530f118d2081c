#pragma once

#include <cmath>

#include "render/support.h"

namespace rambla::tests {

/// Enough for the mean of earlier pictures to be independent of how it began: 0.95^96 < 1 %.
inline constexpr int k_settling_frames = 96;

/// 128 × 128 pixels, seen from 5 m before the middle; everything shines by itself.
struct World {
    static constexpr float k_eye_m = 5.0f;
    static constexpr float k_vertical_fov_rad = 1.0f;

    Stage stage;
    std::uint32_t square = 0;

    explicit World(render::AntiAliasing method = render::AntiAliasing::taa) {
        stage.look({0, 0, k_eye_m}, {0, 0, 0}, k_vertical_fov_rad);
        stage.settings.anti_aliasing.method = method;
        square = stage.square();
    }
    std::uint32_t glowing(glm::vec3 radiance) {
        assets::Material m = matte(radiance);
        m.unlit = true;
        return stage.material(m);
    }
    /// A rectangle, in pixels from the middle of the picture, z in metres towards the eye.
    void place(std::uint32_t material, glm::vec2 low_px, glm::vec2 high_px, float z_m,
               float angle_rad = 0.0f) {
        stage.place(square, material, rectangle(low_px, high_px, z_m, angle_rad));
    }
    static glm::mat4 rectangle(glm::vec2 low_px, glm::vec2 high_px, float z_m, float angle_rad = 0.0f) {
        const float metres_per_px = (k_eye_m - z_m) * std::tan(0.5f * k_vertical_fov_rad) / 64.0f;
        const glm::vec2 centre = 0.5f * metres_per_px * (low_px + high_px);
        const glm::vec2 half = 0.5f * metres_per_px * (high_px - low_px);
        return glm::rotate(glm::mat4{1.0f}, angle_rad, glm::vec3{0, 0, 1}) *
               glm::translate(glm::mat4{1.0f}, glm::vec3{centre, z_m}) *
               glm::scale(glm::mat4{1.0f}, glm::vec3{half, 1.0f});
    }
    Picture after(int frames) {
        Picture picture = stage.draw();
        for (int i = 1; i < frames; ++i)
            picture = stage.draw_next();
        return picture;
    }
};

}  // namespace rambla::tests
