// Adds one local light to the pixels of its rectangle. Defines: BRDF, GBUFFER_WIDE.
#include "gbuffer_read.glsl"
#include "local_light.glsl"
#include "colour.glsl"

flat in uint light_index;

layout(location = 0) out vec4 out_radiance;

void main() {
    PixelSurface p = read_pixel(ivec2(gl_FragCoord.xy));
    vec3 radiance = local_light(lights[light_index], p.surface, p.position, p.to_eye);
    out_radiance = vec4(p.lit ? storable_radiance(radiance * frame.exposure.x) : vec3(0.0), 0.0);
}
