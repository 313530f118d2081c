// ln(δ + luminance) of each pixel, of which mip levels make means.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/luminance.h"
#include "seen_luminance.glsl"

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform LuminanceBlock {
    LuminanceConstants constants;
};

layout(location = 0) out vec2 out_logarithm;  ///< y: 1 for what is no number

void main() {
    float seen = luminance(texelFetch(scene_colour, ivec2(gl_FragCoord.xy), 0).rgb);
    out_logarithm = vec2(log(seen_luminance(seen) + constants.delta.x), is_number(seen) ? 0.0 : 1.0);
}
