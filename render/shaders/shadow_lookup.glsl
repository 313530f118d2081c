// Define TAPS: depth comparisons of sun_through(), 4 or 16; without it, 4.
#include "render/shaders/shared/sun_shadow.h"

#ifndef TAPS
#define TAPS 4
#endif

/// Percentage-closer filtering (Reeves et al. 1987) of a depth map whose comparison yields 1 for lit. Both
/// kernels follow the point continuously between texels: each texel's weight is a piecewise linear function
/// of it.

/// Four comparisons: one gather, bilinear weights. Reaches 1 texel on each axis.
float shadow_pcf_4(sampler2DShadow map, vec2 uv, float depth, vec4 size_texels) {
    vec2 texel = uv * size_texels.xy - 0.5;
    vec2 f = fract(texel);
    vec4 lit = textureGather(map, (floor(texel) + 1.0) * size_texels.zw, depth);
    return mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);
}

/// Sixteen comparisons: four gathers, a box of 3×3 texels that slides (weights 1 − f, 1, 1, f on each axis).
/// Reaches 2 texels on each axis.
float shadow_pcf_16(sampler2DShadow map, vec2 uv, float depth, vec4 size_texels) {
    vec2 texel = uv * size_texels.xy - 0.5;
    vec2 f = fract(texel);
    vec2 corner = floor(texel) + 1.0;
    vec4 lower_left = textureGather(map, (corner + vec2(-1.0, -1.0)) * size_texels.zw, depth);
    vec4 lower_right = textureGather(map, (corner + vec2(1.0, -1.0)) * size_texels.zw, depth);
    vec4 upper_left = textureGather(map, (corner + vec2(-1.0, 1.0)) * size_texels.zw, depth);
    vec4 upper_right = textureGather(map, (corner + vec2(1.0, 1.0)) * size_texels.zw, depth);
    vec4 x = vec4(1.0 - f.x, 1.0, 1.0, f.x);
    // A gather holds (left, top), (right, top), (right, bottom), (left, bottom).
    float row0 = dot(x, vec4(lower_left.wz, lower_right.wz));
    float row1 = dot(x, vec4(lower_left.xy, lower_right.xy));
    float row2 = dot(x, vec4(upper_left.wz, upper_right.wz));
    float row3 = dot(x, vec4(upper_left.xy, upper_right.xy));
    return dot(vec4(1.0 - f.y, 1.0, 1.0, f.y), vec4(row0, row1, row2, row3)) / 9.0;
}

/// Where to look up a surface point, so that it does not shadow itself.
///
/// A filter that reaches r texels compares the point with the depth of its own plane up to r texels aside,
/// which on a slope θ lies r·texel·tan θ nearer to the sun. A point lifted by o along the normal is o/cos θ
/// above its plane as the light sees it: o = r·texel·sin θ is just enough at any slope. bias_m.x holds
/// r·texel. Mapped normals are steeper or flatter than the plane: the floor under sin θ covers tilts of up to
/// 20°.
vec3 shadow_receiver(vec3 position, vec3 normal, vec3 to_sun, vec4 bias_m) {
    const float min_sine = 0.35;
    float cosine = clamp(dot(normal, to_sun), 0.0, 1.0);
    float sine = max(sqrt(1.0 - cosine * cosine), min_sine);
    return position + normal * (bias_m.x * sine) + to_sun * bias_m.y;
}

/// Shadows end softly at the distance up to which the map was fitted.
float shadow_fade(float lit, float distance_m, vec4 fade) {
    return mix(lit, 1.0, clamp((distance_m - fade.x) * fade.y, 0.0, 1.0));
}

/// Share of the sun that its map lets through to a surface point; none to what faces away.
/// @param position  camera-relative world, m
float sun_through(sampler2DShadow map, SunShadow fitted, vec3 position, vec3 normal, vec3 to_sun) {
    vec3 point = shadow_receiver(position, normal, to_sun, fitted.bias_m);
    vec3 place = (fitted.map_from_world * vec4(point, 1.0)).xyz;
#if TAPS == 16
    float lit = shadow_pcf_16(map, place.xy, place.z, fitted.size_texels);
#else
    float lit = shadow_pcf_4(map, place.xy, place.z, fitted.size_texels);
#endif
    return dot(normal, to_sun) > 0.0 ? shadow_fade(lit, length(position), fitted.fade) : 0.0;
}
