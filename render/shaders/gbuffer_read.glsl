// The G-buffer as screen-space passes read it: one fetch per target, at the pixel's own place.
#include "frame.glsl"
#include "brdf.glsl"
#include "gbuffer_layout.glsl"
#include "unproject.glsl"

layout(binding = UNIT_PASS) uniform sampler2D depth_target;
layout(binding = UNIT_PASS + 1) uniform sampler2D albedo_target;
layout(binding = UNIT_PASS + 2) uniform sampler2D normal_target;
layout(binding = UNIT_PASS + 3) uniform sampler2D surface_target;

struct PixelSurface {
    Surface surface;
    vec3 position;  ///< camera-relative world, m
    vec3 to_eye;    ///< unit length, world axes
    bool lit;
};

vec3 world_position(ivec2 pixel) {
    vec2 uv = (vec2(pixel) + 0.5) * frame.size_px.zw;
    // Sky, where a pass is drawn over some, lies far away instead of at infinity.
    const float min_depth = 1e-12;
    float depth = max(texelFetch(depth_target, pixel, 0).x, min_depth);
    return mat3(frame.world_from_view) * view_position(uv, depth, frame.unprojection, frame.depth_scale);
}

/// Towards the eye from a point that is seen; all the same way in an orthographic view. The eye itself looks
/// ahead.
vec3 direction_to_eye(vec3 position) {
    float length2 = dot(position, position);
    bool orthographic = frame.counts.y != 0u;
    return orthographic || length2 < 1e-20 ? frame.world_from_view[2].xyz : -position * inversesqrt(length2);
}

PixelSurface read_pixel(ivec2 pixel) {
    vec4 albedo = texelFetch(albedo_target, pixel, 0);
    vec3 normal = normal_from_stored(texelFetch(normal_target, pixel, 0).xy);
    vec4 surface = texelFetch(surface_target, pixel, 0);
    vec3 position = world_position(pixel);
    return PixelSurface(make_surface(normal, albedo.rgb, surface.x, surface.y, surface.z), position,
                        direction_to_eye(position), albedo.a < 0.5 * (k_class_lit + k_class_unlit));
}
