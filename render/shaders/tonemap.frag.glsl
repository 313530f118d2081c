// Pre-exposed scene colour to the display's sRGB bytes. Defines: CURVE: one of the functions of tone_curves.glsl;
// ON_LUMINANCE, ADAPTED, BLUE_SHIFT, GAMMA, DITHER: 1 where the settings ask for it.
#include "render/shaders/shared/adapted_exposure.h"
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/tonemap.h"
#include "colour.glsl"
#include "night_sight.glsl"
#include "tone_curves.glsl"
#include "tone_on_luminance.glsl"

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform TonemapBlock {
    TonemapConstants constants;
};
#if ADAPTED
layout(std140, binding = BINDING_EXPOSURE) uniform ExposureBlock {
    AdaptedExposure exposure;
};
#endif

layout(location = 0) out vec4 out_display;

vec3 through_curve(vec3 scene, float white) {
#if ON_LUMINANCE
    float y = luminance(scene);
    return y > 0.0 ? at_luminance(scene, y, CURVE(vec3(y), white).g) : vec3(0.0);
#else
    return CURVE(scene, white);
#endif
}

void main() {
    // Blending may have added two finite values to an infinite one; the curves want a number.
    vec3 scene = storable_radiance(texelFetch(scene_colour, ivec2(gl_FragCoord.xy), 0).rgb);
    float white = constants.curve.x;
    float exposed = constants.target.y;
#if ADAPTED
    scene *= exposure.shown.x;
    exposed *= exposure.shown.x;
    white = exposure.shown.y;
#endif
#if BLUE_SHIFT
    scene = seen_by_night(scene, exposed, constants.curve.w);
#endif
    vec3 encoded = encode_srgb(constants.curve.y * through_curve(scene, white));
#if GAMMA
    encoded = pow(encoded, vec3(constants.curve.z));
#endif
    // Luma for edge detection: perceptual weights on encoded values, before the dither that would look like
    // edges.
    float alpha = mix(1.0, dot(encoded, vec3(0.299, 0.587, 0.114)), constants.target.x);
#if DITHER
    encoded = dither_8bit(encoded, gl_FragCoord.xy);
#endif
    out_display = vec4(encoded, alpha);
}
