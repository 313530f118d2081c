// Lists the tiles in which something glows, one workgroup for each.
#define BLOOM_ACCESS
#include "bloom_tiles.glsl"
#include "bloom_bright.glsl"

layout(local_size_x = 64) in;

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;

shared uint something_glows;

bool finds_glow(uvec2 tile) {
    uvec2 first = tile * bloom.tiles.z;
    uvec2 end = min(first + bloom.tiles.z, bloom.size_px.xy);
    uvec2 lane = uvec2(gl_LocalInvocationID.x % 8u, gl_LocalInvocationID.x / 8u);
    bool found = false;
    for (uint y = first.y + lane.y; y < end.y; y += 8u) {
        for (uint x = first.x + lane.x; x < end.x; x += 8u) {
            vec3 light = storable_radiance(texelFetch(scene_colour, ivec2(x, y), 0).rgb);
            found = found || luminance(light) > bloom.bright.x;
        }
    }
    return found;
}

void main() {
    if (gl_LocalInvocationID.x == 0u) something_glows = 0u;
    barrier();
    if (finds_glow(gl_WorkGroupID.xy)) atomicOr(something_glows, 1u);
    barrier();
    if (gl_LocalInvocationID.x != 0u || something_glows == 0u) return;
    uint place = atomicAdd(bloom_draws[k_bloom_draw_bright].tile_count, 1u);
    bloom_tiles[place] = gl_WorkGroupID.y * bloom.tiles.x + gl_WorkGroupID.x;
    atomicMax(bloom_draws[k_bloom_draw_spread].tile_count, 1u);
}
