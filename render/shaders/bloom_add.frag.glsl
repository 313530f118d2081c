// The glow that is added to a pixel. It fades out where it is too faint to be seen, so that tiles which are left out
// have no edges.
#include "bloom_tiles.glsl"

layout(binding = UNIT_PASS) uniform sampler2D spread_light;

layout(location = 0) out vec4 out_light;

void main() {
    vec2 texels = float(bloom.tiles.w) * vec2(textureSize(spread_light, 0));
    vec3 light = bloom.shown.x * texture(spread_light, gl_FragCoord.xy / texels).rgb;
    float brightest = max(light.r, max(light.g, light.b));
    out_light = vec4(light * smoothstep(bloom.shown.y, 2.0 * bloom.shown.y, brightest), 0.0);
}
