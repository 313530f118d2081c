// Where on a surface with heights an eye looks, without geometry for them: shifts of texture coordinates. A depth is
// how far below the highest point something lies, as a share of the deepest, 0 to 1.

float relief_depth(vec2 uv);  ///< the includer's

/// The direction to the eye rises at least as steeply as this, as far as shifts are concerned: at grazing angles they would
/// grow without bound.
const float k_least_rise = 0.125;

/// The shift at the deepest point along the direction to the eye (unit length; z along the normal, y up the texture, whose
/// v points down).
vec2 deepest_shift(vec3 to_eye, float depth) {
    return vec2(-to_eye.x, to_eye.y) * (depth / max(to_eye.z, k_least_rise));
}

/// Offset limiting (Welsh 2004): as if the surface were flat at the depth beneath the pixel, and the shift no longer than that
/// depth.
vec2 limited_shift(vec3 to_eye, float depth) {
    return vec2(-to_eye.x, to_eye.y) * depth;
}

/// Parallax occlusion mapping (Brawley and Tatarchuk 2004): walks from the highest point down in `steps` equal steps along
/// the whole `shift` until the surface lies above, and takes it for straight between the last two places. Returns the share of
/// the shift, 0 to 1; within 1/steps of the first place where the line enters the surface, if nothing is narrower than a
/// step.
float relief_entry(vec2 uv, vec2 shift, int steps) {
    float each = 1.0 / float(steps);
    float above = relief_depth(uv);  // how far the line is above the surface
    if (above <= 0.0) return 0.0;
    for (int i = 1; i < steps; ++i) {
        float along = float(i) * each;
        float next = relief_depth(uv + along * shift) - along;
        if (next <= 0.0) return along - each * next / (next - above);
        above = next;
    }
    // At the end, nothing lies deeper.
    float next = relief_depth(uv + shift) - 1.0;
    return 1.0 - each * next / min(next - above, -1e-6);
}
