// The dual filter: Bjørge 2015, "Bandwidth-Efficient Rendering", SIGGRAPH. Define DOWN: 1 halves the size, by the middle
// and the four corners of the new texel; 0 doubles it, by eight places on a circle around the pixel, half a coarse texel
// off on both axes or a whole one along one of them, and adds a share of the finer level.
#include "bloom_step.glsl"

#if DOWN

void main() {
    vec2 middle = 2.0 * gl_FragCoord.xy;
    vec3 sum = 4.0 * light_at(source, middle);
    for (int i = 0; i < 4; ++i)
        sum += light_at(source, middle + 2.0 * vec2(i & 1, i >> 1) - 1.0);
    out_light = vec4(sum / 8.0, 0.0);
}

#else

void main() {
    vec2 middle = 0.5 * gl_FragCoord.xy;
    vec3 sum = light_at(source, middle + vec2(1.0, 0.0)) + light_at(source, middle - vec2(1.0, 0.0)) +
               light_at(source, middle + vec2(0.0, 1.0)) + light_at(source, middle - vec2(0.0, 1.0));
    for (int i = 0; i < 4; ++i)
        sum += 2.0 * light_at(source, middle + vec2(i & 1, i >> 1) - 0.5);
    vec3 finer = texelFetch(other, ivec2(gl_FragCoord.xy), 0).rgb;
    out_light = vec4(bloom_step.share.x * sum / 12.0 + bloom_step.share.y * finer, 0.0);
}

#endif
