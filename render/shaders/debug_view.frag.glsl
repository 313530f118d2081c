// One of the things that a picture is made from. Defines: VIEW, the function below that is shown; MISSING: 1 where the
// frame does not have it; CELLS, TILES: which lists of lights are bound; IDS: 1 where it is whole
// numbers; GBUFFER_WIDE.
#include "frame.glsl"
#include "gbuffer_layout.glsl"
#include "unproject.glsl"
#include "render/shaders/shared/light_cells.h"
#if CELLS
#include "light_cells.glsl"
#endif
#if TILES
#include "tiles.glsl"
#endif

layout(binding = UNIT_PASS) uniform sampler2D depth_target;
#if IDS
layout(binding = UNIT_PASS + 1) uniform usampler2D source;
#else
layout(binding = UNIT_PASS + 1) uniform sampler2D source;
#endif

layout(location = 0) uniform int samples;  ///< pixels drawn for one that is shown, across and down

layout(location = 0) out vec4 out_display;

const float k_steps_shown = 8.0;   ///< lights or layers that are drawn in full red
const float k_depth_scale_m = 20.0;  ///< this far away is middle grey
const float k_stops_shown = 8.0;   ///< of luminance, to either side of white under the noon sun

/// Of those drawn for the one that is shown, the middle one.
ivec2 pixel() {
    return ivec2(gl_FragCoord.xy) * samples + samples / 2;
}

float seen_depth() {
    return texelFetch(depth_target, pixel(), 0).x;
}

float distance_m(float depth) {
    return -view_position(vec2(0.5), max(depth, 1e-12), frame.unprojection, frame.depth_scale).z;
}

/// From blue (0) over green to red (1).
vec3 heat(float share) {
    float x = clamp(share, 0.0, 1.0);
    return clamp(vec3(2.0 * x - 0.6, 1.2 - abs(2.4 * x - 1.2), 1.0 - 2.2 * x), 0.0, 1.0);
}

vec3 of_surface(vec3 value) {
    return seen_depth() > 0.0 ? value : vec3(0.0);
}

#if IDS
/// A colour for each object, alike for none of its neighbours in the list of entities: steps of the golden ratio in hue.
vec3 view_objects() {
    uint id = texelFetch(source, pixel(), 0).x;
    float hue = fract(float(id) * 0.61803399);
    vec3 pure = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    float value = 0.55 + 0.45 * fract(float(id) * 0.7548777);
    return id == 0u ? vec3(0.0) : value * mix(vec3(1.0), pure, 0.6);
}
#else
vec3 view_albedo() {
    vec3 albedo = texelFetch(source, pixel(), 0).rgb;
#if GBUFFER_WIDE
    albedo = encode_srgb(albedo);
#endif
    return of_surface(albedo);
}
/// As it is stored: without the normal map in the wide layout.
vec3 view_normal() {
    vec3 stored = texelFetch(source, pixel(), 0).xyz;
#if GBUFFER_WIDE
    return of_surface(0.5 + 0.5 * normalize(stored));
#else
    return of_surface(0.5 + 0.5 * normal_from_stored(stored.xy));
#endif
}
vec3 view_roughness() {
    return of_surface(texelFetch(source, pixel(), 0).xxx);
}
vec3 view_metalness() {
    return of_surface(texelFetch(source, pixel(), 0).yyy);
}
vec3 view_occlusion() {
    return of_surface(texelFetch(source, pixel(), 0).zzz);
}
vec3 view_emission() {
    return of_surface(encode_srgb(texelFetch(source, pixel(), 0).rgb * frame.exposure.x));
}
/// White at the eye, black infinitely far.
vec3 view_depth() {
    float z = distance_m(seen_depth());
    return of_surface(vec3(k_depth_scale_m / (k_depth_scale_m + z)));
}
vec3 view_shadow() {
    return of_surface(texelFetch(source, pixel(), 0).xxx);
}
/// How many lights the pixel's cell lists.
vec3 view_lights() {
#if CELLS
    uint count = lights_of_pixel(uvec2(pixel()), distance_m(seen_depth())).y;
    return of_surface(count == 0u ? vec3(0.05) : heat(float(count) / k_steps_shown));
#else
    return vec3(0.0);
#endif
}
/// Lamp-lit tiles orange, by the number of their lamps; others green; sky blue. Rims of tiles are darker.
vec3 view_tiles() {
#if TILES
    uvec2 tile = uvec2(pixel()) / tile_grid.cells.w;
    uint lights = tile_ranges[tile.y * tile_grid.cells.x + tile.x].y;
    vec3 colour = lights == 0u ? vec3(0.15, 0.45, 0.2) : mix(vec3(0.5, 0.3, 0.1), vec3(1.0, 0.3, 0.1),
                                                             min(float(lights) / k_steps_shown, 1.0));
    uvec2 within = uvec2(pixel()) % tile_grid.cells.w;
    bool rim = any(lessThan(within, uvec2(samples)));
    return (seen_depth() > 0.0 ? colour : vec3(0.1, 0.2, 0.5)) * (rim ? 0.5 : 1.0);
#else
    return vec3(0.0);
#endif
}
/// Opaque surfaces over each other, hidden ones included.
vec3 view_overdraw() {
    return heat(texelFetch(source, pixel(), 0).x / k_steps_shown);
}
/// Blue: 8 stops below white under the noon sun; green: white; red: 8 stops above.
vec3 view_luminance() {
    float y = luminance(texelFetch(source, pixel(), 0).rgb * frame.exposure.y);
    return y > 0.0 ? heat(0.5 + 0.5 * log2(y) / k_stops_shown) : vec3(0.0);
}
/// Pixels that are no numbers are magenta, infinite ones cyan, all others dim.
vec3 view_nonfinite() {
    vec3 radiance = texelFetch(source, pixel(), 0).rgb;
    if (any(isnan(radiance))) return vec3(1.0, 0.0, 1.0);
    if (any(isinf(radiance))) return vec3(0.0, 1.0, 1.0);
    return 0.25 * encode_srgb(radiance);
}
#endif

void main() {
#if MISSING
    ivec2 shown = pixel() / samples;
    bool stripe = (shown.x + shown.y) / 16 % 2 == 0;
    out_display = vec4(vec3(stripe ? 0.35 : 0.3), 1.0);
#else
    out_display = vec4(VIEW(), 1.0);
#endif
}
