// The G-buffer as screen-space passes read it: one fetch per target, at the pixel's own place.
#include "frame.glsl"
#include "brdf.glsl"
#include "gbuffer_layout.glsl"
#include "unproject.glsl"
#include "to_eye.glsl"

layout(binding = UNIT_PASS) uniform sampler2D depth_target;
layout(binding = UNIT_PASS + 1) uniform sampler2D albedo_target;
layout(binding = UNIT_PASS + 2) uniform sampler2D normal_target;
layout(binding = UNIT_PASS + 3) uniform sampler2D surface_target;

struct PixelSurface {
    Surface surface;
    vec3 position;     ///< camera-relative world, m
    vec3 to_eye;       ///< unit length, world axes
    float distance_m;  ///< from the eye, along the view
    bool lit;
};

vec3 seen_position(ivec2 pixel) {
    vec2 uv = (vec2(pixel) + 0.5) * frame.size_px.zw;
    // Sky, where a pass is drawn over some, lies far away instead of at infinity.
    const float min_depth = 1e-12;
    float depth = max(texelFetch(depth_target, pixel, 0).x, min_depth);
    return view_position(uv, depth, frame.unprojection, frame.depth_scale);
}

vec3 world_position(ivec2 pixel) {
    return mat3(frame.world_from_view) * seen_position(pixel);
}

PixelSurface read_pixel(ivec2 pixel) {
    vec4 albedo = texelFetch(albedo_target, pixel, 0);
    vec3 normal = normal_from_stored(texelFetch(normal_target, pixel, 0).xy);
    vec4 surface = texelFetch(surface_target, pixel, 0);
    vec3 seen = seen_position(pixel);
    vec3 position = mat3(frame.world_from_view) * seen;
    return PixelSurface(make_surface(normal, albedo_from_stored(albedo.rgb), surface.x, surface.y, surface.z,
                                     reflectance_from_stored(albedo.a)),
                        position, direction_to_eye(position), -seen.z, is_lit(albedo.a));
}
