// Sun, sky and emission of every pixel that shows geometry, and local lights. Defines: SHADOW_RESULT, EMISSION,
// LOCAL_LIGHTS, BRDF, GBUFFER_WIDE.
#include "gbuffer_read.glsl"
#include "sun_and_sky.glsl"
#include "local_lights.glsl"
#include "colour.glsl"

#if SHADOW_RESULT
layout(binding = UNIT_PASS + 4) uniform sampler2D shadow_result;
#endif
#if EMISSION
layout(binding = UNIT_PASS + 5) uniform sampler2D emission_target;
#endif

layout(location = 0) out vec4 out_radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    PixelSurface p = read_pixel(pixel);
    float lit = 1.0;
#if SHADOW_RESULT
    lit = texelFetch(shadow_result, pixel, 0).x;
#endif
    vec3 radiance = sky_light(p.surface, p.to_eye) + sun_light(p.surface, p.to_eye, lit) +
                    directional_lights(p.surface, p.to_eye) +
                    local_lights(p.surface, p.position, p.to_eye, p.distance_m);
    radiance = p.lit ? radiance : vec3(0.0);
#if EMISSION
    radiance += texelFetch(emission_target, pixel, 0).rgb;
#endif
    out_radiance = vec4(storable_radiance(radiance * frame.exposure.x), 1.0);
}
