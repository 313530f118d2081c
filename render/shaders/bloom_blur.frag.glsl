// One axis of a separable blur, by taps between two texels each. Define PAIRS of taps, and ONTO: 1 adds the next coarser
// level, of texels twice as large.
#include "bloom_step.glsl"

/// Nothing is known of what lies beyond the border: what is inside counts for it, and flat areas stay flat. Where the border
/// lies between a tap's two texels, the sampler finds the nearer one alone.
/// @param inside  texels from the middle to the border
float known_weight(float inside, vec4 tap) {
    return tap.w < inside ? tap.y : tap.w - 1.0 < inside ? tap.z : 0.0;
}

void main() {
    vec2 texel = gl_FragCoord.xy;
    vec2 axis = bloom_step.axis.xy;
    float end = dot(axis, vec2(textureSize(source, 0)));
    float middle = dot(axis, texel);
    float weights = bloom_step.share.z;
    vec3 sum = weights * texelFetch(source, ivec2(texel), 0).rgb;
    for (int i = 0; i < PAIRS; ++i) {
        vec4 tap = bloom_step.taps[i];
        float before = known_weight(middle, tap);
        float after = known_weight(end - middle, tap);
        sum += before * light_at(source, texel - tap.x * axis) + after * light_at(source, texel + tap.x * axis);
        weights += before + after;
    }
    vec3 light = bloom_step.share.x * sum / weights;
#if ONTO
    light += bloom_step.share.y * light_at(other, 0.5 * texel);
#endif
    out_light = vec4(light, 0.0);
}
