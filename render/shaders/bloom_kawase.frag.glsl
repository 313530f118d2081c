// Four corners around a texel, farther out with each pass. Kawase 2003, "Frame Buffer Postprocessing Effects in
// DOUBLE-S.T.E.A.L".
#include "bloom_step.glsl"

void main() {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i)
        sum += light_at(source, gl_FragCoord.xy + bloom_step.axis.xy * (2.0 * vec2(i & 1, i >> 1) - 1.0));
    out_light = vec4(0.25 * sum, 0.0);
}
