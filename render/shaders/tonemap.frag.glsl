// Pre-exposed scene colour to the display's sRGB bytes. Define CURVE: one of the functions of
// tone_curves.glsl.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/tonemap.h"
#include "colour.glsl"
#include "tone_curves.glsl"

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform TonemapBlock {
    TonemapConstants constants;
};

layout(location = 0) out vec4 out_display;

void main() {
    // Blending may have added two finite values to an infinite one; the curves want a number.
    vec3 scene = storable_radiance(texelFetch(scene_colour, ivec2(gl_FragCoord.xy), 0).rgb);
    vec3 encoded = encode_srgb(CURVE(scene));
    // Luma for edge detection: perceptual weights on encoded values, before the dither that would look like
    // edges.
    float alpha = mix(1.0, dot(encoded, vec3(0.299, 0.587, 0.114)), constants.alpha.x);
    out_display = vec4(dither_8bit(encoded, gl_FragCoord.xy), alpha);
}
