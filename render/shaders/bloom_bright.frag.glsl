// Glowing light of the pixels about a texel, weighted by a tent as wide as two texels: a pixel's light goes to its
// nearest texels in the shares of a linear interpolation, so that the place where it comes from is kept and does not
// jump from texel to texel as it moves. Define FIREFLIES: 1 lets lone bright pixels count less.
#include "bloom_tiles.glsl"
#include "bloom_bright.glsl"

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;

layout(location = 0) out vec4 out_light;

vec3 light_at(ivec2 pixel) {
    return glowing_light(texelFetch(scene_colour, pixel, 0).rgb, bloom.bright.xyz);
}

void main() {
    int texel_px = int(bloom.tiles.w);
    vec2 centre = floor(gl_FragCoord.xy) * float(texel_px) + 0.5 * float(texel_px);
    ivec2 first = max(ivec2(floor(gl_FragCoord.xy)) * texel_px - texel_px / 2, ivec2(0));
    ivec2 end = min(ivec2(floor(gl_FragCoord.xy)) * texel_px + 3 * texel_px / 2, ivec2(bloom.size_px.xy));
    vec3 sum = vec3(0.0);
    float weights = 0.0;  // of pixels that there are: what is beyond the border is not known
    for (int y = first.y; y < end.y; ++y) {
        float weight_y = float(texel_px) - abs(float(y) + 0.5 - centre.y);
        for (int x = first.x; x < end.x; ++x) {
            float weight = weight_y * (float(texel_px) - abs(float(x) + 0.5 - centre.x));
            vec3 light = light_at(ivec2(x, y));
#if FIREFLIES
            weight *= firefly_weight(light);
#endif
            sum += weight * light;
            weights += weight;
        }
    }
    out_light = vec4(sum / weights, 0.0);
}
