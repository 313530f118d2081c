// Lists the tiles on which glow is seen, one workgroup for each.
#define BLOOM_ACCESS
#include "bloom_tiles.glsl"

layout(local_size_x = 64) in;

layout(binding = UNIT_PASS) uniform sampler2D spread_light;

shared uint is_seen;

/// Texels of the tile and those next to them, of which pixels at its border are interpolated.
bool finds_glow(uvec2 tile) {
    int texels = int(bloom.tiles.z / bloom.tiles.w);
    ivec2 first = max(ivec2(tile) * texels - 1, ivec2(0));
    ivec2 end = min(ivec2(tile + 1u) * texels + 1, textureSize(spread_light, 0));
    ivec2 lane = ivec2(gl_LocalInvocationID.x % 8u, gl_LocalInvocationID.x / 8u);
    bool found = false;
    for (int y = first.y + lane.y; y < end.y; y += 8) {
        for (int x = first.x + lane.x; x < end.x; x += 8) {
            vec3 light = bloom.shown.x * texelFetch(spread_light, ivec2(x, y), 0).rgb;
            found = found || max(light.r, max(light.g, light.b)) > bloom.shown.y;
        }
    }
    return found;
}

void main() {
    if (gl_LocalInvocationID.x == 0u) is_seen = 0u;
    barrier();
    bool anything = bloom_draws[k_bloom_draw_spread].tile_count > 0u;  // else the texture was not drawn
    if (anything && finds_glow(gl_WorkGroupID.xy)) atomicOr(is_seen, 1u);
    barrier();
    if (gl_LocalInvocationID.x != 0u || is_seen == 0u) return;
    uint place = atomicAdd(bloom_draws[k_bloom_draw_visible].tile_count, 1u);
    bloom_tiles[bloom.tiles.x * bloom.tiles.y + place] = gl_WorkGroupID.y * bloom.tiles.x + gl_WorkGroupID.x;
}
