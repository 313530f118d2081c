// What methods of anti-aliasing look for edges in. Defines: EDGES, SOBEL and SOBEL_OF_DEPTH: 1 where that is depth, and
// not the luma of the picture; NORMALS and GBUFFER_WIDE: whether there are normals, and how they are kept.
#include "render/shaders/shared/bindings.h"

layout(binding = UNIT_PASS) uniform sampler2D display;  ///< linear filter; luma in alpha

#if EDGES || (SOBEL && SOBEL_OF_DEPTH)
layout(binding = UNIT_PASS + 1) uniform sampler2D depth_target;

/// Of the texels that meet at a corner: (left, top), (right, top), (right, bottom), (left, bottom).
vec4 gather_source(vec2 corner_uv) {
    return textureGather(depth_target, corner_uv, 0);
}
#else
vec4 gather_source(vec2 corner_uv) {
    return textureGather(display, corner_uv, 3);
}
#endif

#if EDGES && NORMALS
#include "gbuffer_layout.glsl"
layout(binding = UNIT_PASS + 2) uniform sampler2D normal_target;

/// World axes; outside of the picture, that of its border.
vec3 source_normal(ivec2 pixel) {
    ivec2 place = clamp(pixel, ivec2(0), textureSize(normal_target, 0) - 1);
    // Where nothing is, nothing is stored but what memory held; depth finds the edges of that.
    if (texelFetch(depth_target, place, 0).x <= 0.0) return vec3(0.0, 0.0, 1.0);
    vec4 stored = texelFetch(normal_target, place, 0);
#if GBUFFER_WIDE
    return dot(stored.xyz, stored.xyz) > 0.0 ? normalize(stored.xyz) : vec3(0.0, 0.0, 1.0);
#else
    return normal_from_stored(stored.xy);
#endif
}
#endif

/// The value of a pixel and its eight neighbours.
void gather_neighbours(vec2 uv, vec2 texel, out float nine[9]) {
    vec4 upper_right = gather_source(uv + 0.5 * texel);
    vec4 lower_left = gather_source(uv - 0.5 * texel);
    vec4 upper_left = gather_source(uv + vec2(-0.5, 0.5) * texel);
    vec4 lower_right = gather_source(uv + vec2(0.5, -0.5) * texel);
    nine = float[](lower_left.w, lower_left.z, lower_right.z,  //
                   lower_left.x, upper_right.w, upper_right.z,  //
                   upper_left.x, upper_right.x, upper_right.y);
}
