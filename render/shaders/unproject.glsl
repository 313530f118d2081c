/// Eye-space position of a pixel from its depth, for the projections of the engine: perspective with reversed
/// Z and infinite far plane, orthographic with reversed linear Z.
///
/// Perspective: clip = (a·x + b·z, …, near, −z), so depth = near/(−z) and x = −z·(2·x_w − 1 + b)/a.
/// Orthographic: x does not depend on z, which is linear in depth.
///
/// @param uv            of the pixel's centre, [0, 1]², origin in the lower left corner
/// @param depth         window depth; > 0 in a perspective, where 0 is no point: callers skip the sky
/// @param unprojection  as in FrameUniforms
/// @param depth_scale   as in FrameUniforms
vec3 view_position(vec2 uv, float depth, vec4 unprojection, vec4 depth_scale) {
    vec2 plane = (2.0 * uv - 1.0 + unprojection.zw) * unprojection.xy;
    bool perspective = depth_scale.x > 0.0;
    float z = perspective ? -depth_scale.x / depth : depth_scale.y * depth + depth_scale.z;
    return vec3(perspective ? -z * plane : plane, z);
}

/// Direction from the eye through a pixel, in eye space, unit length.
vec3 view_ray(vec2 uv, vec4 unprojection, vec4 depth_scale) {
    vec2 plane = (2.0 * uv - 1.0 + unprojection.zw) * unprojection.xy;
    return depth_scale.x > 0.0 ? normalize(vec3(plane, -1.0)) : vec3(0.0, 0.0, -1.0);
}
