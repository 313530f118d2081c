// One axis of a separable blur, by taps between two texels each. Define PAIRS of taps, and ONTO: 1 adds the next coarser
// level, of texels twice as large.
#include "bloom_step.glsl"

void main() {
    vec2 texel = gl_FragCoord.xy;
    vec2 axis = bloom_step.axis.xy;
    float end = dot(axis, vec2(textureSize(source, 0)));
    float middle = dot(axis, texel);
    float weights = bloom_step.share.z;
    vec3 sum = weights * texelFetch(source, ivec2(texel), 0).rgb;
    for (int i = 0; i < PAIRS; ++i) {
        vec2 tap = bloom_step.taps[i].xy;
        // Nothing is known of what lies beyond the border: what is inside counts for it, and flat areas stay flat.
        float before = middle - tap.x > 0.0 ? tap.y : 0.0;
        float after = middle + tap.x < end ? tap.y : 0.0;
        sum += before * light_at(source, texel - tap.x * axis) + after * light_at(source, texel + tap.x * axis);
        weights += before + after;
    }
    vec3 light = bloom_step.share.x * sum / weights;
#if ONTO
    light += bloom_step.share.y * light_at(other, 0.5 * texel);
#endif
    out_light = vec4(light, 0.0);
}
