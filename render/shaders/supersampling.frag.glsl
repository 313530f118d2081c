// The mean of all pixels that are drawn for one that is shown: a box filter, in the light that a display sends.
#include "render/shaders/shared/bindings.h"
#include "colour.glsl"

layout(binding = UNIT_PASS) uniform sampler2D display;  ///< tone-mapped, sRGB-encoded
layout(location = 0) uniform ivec2 samples_and_dither;  ///< x: drawn for one shown, across and down; y: 0 or 1

layout(location = 0) out vec4 out_display;

void main() {
    int samples = samples_and_dither.x;
    ivec2 corner = ivec2(gl_FragCoord.xy) * samples;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < samples; ++y) {
        for (int x = 0; x < samples; ++x)
            sum += decode_srgb(texelFetch(display, corner + ivec2(x, y), 0).rgb);
    }
    vec3 encoded = encode_srgb(sum / float(samples * samples));
    out_display = vec4(samples_and_dither.y != 0 ? dither_8bit(encoded, gl_FragCoord.xy) : encoded, 1.0);
}
