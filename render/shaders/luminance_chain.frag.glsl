// One step of the sum of ln(δ + luminance) over a picture: each pixel is the sum over a block of 4×4 of the step
// before, or of the picture. Blocks at the rims are what is left, so that every pixel counts once, whatever the
// size. Define FIRST: 1 reads the picture.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/luminance.h"
#include "seen_luminance.glsl"

layout(binding = UNIT_PASS) uniform sampler2D source;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform LuminanceBlock {
    LuminanceConstants constants;
};

layout(location = 0) out vec2 out_sums;  ///< x: of the logarithms, y: pixels that are no numbers

const int k_block = 4;

void main() {
    ivec2 size = textureSize(source, 0);
    ivec2 first = k_block * ivec2(gl_FragCoord.xy);
    vec2 sums = vec2(0.0);
    for (int y = 0; y < k_block; ++y) {
        vec4 row = vec4(1.0);  // whose logarithm is 0
        for (int x = 0; x < k_block; ++x) {
            ivec2 place = first + ivec2(x, y);
            bool inside = all(lessThan(place, size));
            vec3 texel = texelFetch(source, min(place, size - 1), 0).rgb;
#if FIRST
            float seen = luminance(texel);
            row[x] = inside ? seen_luminance(seen) + constants.delta.x : 1.0;
            sums.y += inside && !is_number(seen) ? 1.0 : 0.0;
#else
            sums += inside ? texel.xy : vec2(0.0);
#endif
        }
#if FIRST
        sums.x += sum_of_logs(row);
#endif
    }
    out_sums = sums;
}
