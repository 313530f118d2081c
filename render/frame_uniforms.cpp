#include "render/frame_uniforms.h"

namespace rambla::render {

shared::FrameUniforms make_frame_uniforms(const systems::Frame& frame, const systems::FrameView& view,
                                          float exposure, const DetailParameters& detail) {
    const glm::mat4& p = view.clip_from_view;
    const assets::Environment& light = frame.environment;
    const glm::vec2 size{view.size_px};
    shared::FrameUniforms u{};
    u.view_from_world = view.view_from_world;
    u.world_from_view = glm::inverse(view.view_from_world);
    u.clip_from_view = p;
    u.clip_from_world = p * view.view_from_world;
    // Perspective: x_ndc = (a·x + b·z)/(−z), hence x = −z·(x_ndc + b)/a with b = p[2].x. Orthographic: x_ndc
    // = a·x + t, hence x = (x_ndc − t)/a with t = p[3].x. Depth: near/(−z), and p[2].z·z + p[3].z.
    const glm::vec2 shift = view.orthographic ? -glm::vec2{p[3]} : glm::vec2{p[2]};
    u.unprojection = glm::vec4{1.0f / p[0].x, 1.0f / p[1].y, shift};
    u.depth_scale = view.orthographic ? glm::vec4{0.0f, 1.0f / p[2].z, -p[3].z / p[2].z, 0.0f}
                                      : glm::vec4{p[3].z, 0.0f, 0.0f, 0.0f};
    u.size_px = glm::vec4{size, 1.0f / size};
    u.direction_to_sun = glm::vec4{light.direction_to_sun, 0.0f};
    u.sun_illuminance = glm::vec4{light.sun_illuminance, 0.0f};
    u.sky_zenith_radiance = glm::vec4{light.sky_zenith_radiance, 0.0f};
    u.sky_horizon_radiance = glm::vec4{light.sky_horizon_radiance, 0.0f};
    u.ground_radiance = glm::vec4{light.ground_radiance, light.sky_visibility};
    u.exposure = glm::vec4{exposure, 1.0f / exposure, 0.0f, 0.0f};
    u.eye_cell = glm::vec4{glm::vec3{view.eye_cell}, 0.0f};
    u.eye_local_m = glm::vec4{view.eye_local_m, static_cast<float>(frame.time_s)};
    u.counts = glm::uvec4{static_cast<std::uint32_t>(frame.lights.size()), view.orthographic ? 1u : 0u,
                          static_cast<std::uint32_t>(frame.directional_lights.size()),
                          static_cast<std::uint32_t>(detail.steps)};
    return u;
}

}  // namespace rambla::render
