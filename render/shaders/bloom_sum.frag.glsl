// A share of one light added to a share of another of the same size. Define ONTO: 0 leaves the other out.
#include "bloom_step.glsl"

void main() {
    vec3 light = bloom_step.share.x * texelFetch(source, ivec2(gl_FragCoord.xy), 0).rgb;
#if ONTO
    light += bloom_step.share.y * texelFetch(other, ivec2(gl_FragCoord.xy), 0).rgb;
#endif
    out_light = vec4(light, 0.0);
}
