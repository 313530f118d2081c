// The G-buffer as screen-space passes read it, at the pixel's own place. Define GBUFFER_WIDE.
#include "frame.glsl"
#include "brdf.glsl"
#include "gbuffer_layout.glsl"
#include "unproject.glsl"
#include "to_eye.glsl"
#include "tangent_space.glsl"

layout(binding = UNIT_PASS) uniform sampler2D depth_target;
layout(binding = UNIT_PASS + 1) uniform sampler2D albedo_target;
layout(binding = UNIT_PASS + 2) uniform sampler2D normal_target;
layout(binding = UNIT_PASS + 3) uniform sampler2D surface_target;
#if GBUFFER_WIDE
layout(binding = UNIT_PASS + 6) uniform sampler2D position_target;
layout(binding = UNIT_PASS + 7) uniform sampler2D tangent_target;
#endif

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
#if GBUFFER_WIDE
    return texelFetch(position_target, pixel, 0).xyz;
#else
    return mat3(frame.world_from_view) * seen_position(pixel);
#endif
}

vec3 world_normal(ivec2 pixel) {
#if GBUFFER_WIDE
    vec4 tangent = texelFetch(tangent_target, pixel, 0);
    vec4 normal = texelFetch(normal_target, pixel, 0);
    vec3 map = vec3(texelFetch(albedo_target, pixel, 0).a, tangent.a, normal.a);
    return normalize(tilted_normal(TangentSpace(tangent.xyz, map), normalize(normal.xyz)));
#else
    return normal_from_stored(texelFetch(normal_target, pixel, 0).xy);
#endif
}

/// Colour, and alpha as RT0 of the compact layout has it.
vec4 stored_base(ivec2 pixel) {
    vec4 albedo = texelFetch(albedo_target, pixel, 0);
#if GBUFFER_WIDE
    return vec4(albedo.rgb, texelFetch(position_target, pixel, 0).a);
#else
    return vec4(albedo_from_stored(albedo.rgb), albedo.a);
#endif
}

PixelSurface read_pixel(ivec2 pixel) {
    vec4 base = stored_base(pixel);
    vec4 surface = texelFetch(surface_target, pixel, 0);
    vec3 position = world_position(pixel);
    float distance_m = -seen_position(pixel).z;  // by depth, as the lists of lights go
    return PixelSurface(make_surface(world_normal(pixel), base.rgb, surface.x, surface.y, surface.z,
                                     reflectance_from_stored(base.a)),
                        position, direction_to_eye(position), distance_m, is_lit(base.a));
}
