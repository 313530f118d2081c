// Adds one local light to the pixels of its volume. Defines: BRDF, GBUFFER_WIDE, MEETS_SKY: 1 where the depth test
// keeps pixels that show nothing.
#include "gbuffer_read.glsl"
#include "local_light.glsl"
#include "colour.glsl"

flat in uint light_index;

layout(location = 0) out vec4 out_radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    out_radiance = vec4(0.0);
#if MEETS_SKY
    if (texelFetch(depth_target, pixel, 0).x <= 0.0) return;
#endif
    PixelSurface p = read_pixel(pixel);
    vec3 radiance = local_light(lights[light_index], p.surface, p.position, p.to_eye);
    if (p.lit) out_radiance.rgb = storable_radiance(radiance * frame.exposure.x);
}
