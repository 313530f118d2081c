// Half the size, by the weights 1 3 3 1 along each axis: like the tent that made the first level, they keep the place
// where light comes from. Four fetches, each three parts from the nearer texel and one from the farther.
#include "bloom_step.glsl"

const float k_between_three_and_one = 0.75;

void main() {
    vec2 middle = 2.0 * gl_FragCoord.xy;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i)
        sum += light_at(source, middle + k_between_three_and_one * (2.0 * vec2(i & 1, i >> 1) - 1.0));
    out_light = vec4(0.25 * sum, 0.0);
}
