// Sorts the screen's tiles by what lighting them takes, one workgroup for each. A tile's candidates are the lights whose
// rectangles touch it; those remain that reach the depths which it shows. Olsson and Assarsson 2011, "Tiled shading".
#define TILE_ACCESS
#include "frame.glsl"
#include "unproject.glsl"
#include "tiles.glsl"

layout(local_size_x = 64) in;

layout(binding = UNIT_PASS) uniform sampler2D depth_target;
layout(std430, binding = BINDING_PASS_STORAGE + 3) readonly buffer LightDepthBlock {
    LightDepths light_depths[];  ///< by row of the frame's lights
};
layout(std430, binding = BINDING_PASS_STORAGE + 4) readonly buffer CandidateRangeBlock {
    LightGrid candidate_grid;
    uvec2 candidate_ranges[];  ///< of candidates, by tile
};
layout(std430, binding = BINDING_PASS_STORAGE + 5) readonly buffer CandidateBlock {
    uint candidates[];  ///< rows of the frame's lights
};

/// Bits of depths, which order as the floats do that are not negative.
shared uint nearest_depth;
shared uint farthest_depth;

/// Depths and distances are rounded on different ways; what ends that close to each other may touch.
const float k_slack = 1e-3;

float distance_m(float depth) {
    return -view_position(vec2(0.5), depth, frame.unprojection, frame.depth_scale).z;
}

void find_depths(uvec2 tile) {
    uvec2 first = tile * tile_grid.cells.w;
    uvec2 size = min(uvec2(tile_grid.cells.w), uvec2(frame.size_px.xy) - first);
    uint nearest = 0u;
    uint farthest = 0xffffffffu;
    for (uint y = gl_LocalInvocationID.x / 8u; y < size.y; y += 8u) {
        for (uint x = gl_LocalInvocationID.x % 8u; x < size.x; x += 8u) {
            uint depth = floatBitsToUint(texelFetch(depth_target, ivec2(first + uvec2(x, y)), 0).x);
            nearest = max(nearest, depth);
            farthest = min(farthest, depth == 0u ? 0xffffffffu : depth);
        }
    }
    atomicMax(nearest_depth, nearest);
    atomicMin(farthest_depth, farthest);
}

/// The lights stay in their order, so that sums are rounded the same in every frame: one invocation lists them all.
uint list_lights(uint tile) {
    uvec2 range = candidate_ranges[tile];
    float near_m = distance_m(uintBitsToFloat(nearest_depth)) * (1.0 - k_slack);
    float far_m = distance_m(uintBitsToFloat(farthest_depth)) * (1.0 + k_slack);
    uint count = 0u;
    for (uint i = range.x; i < range.x + range.y; ++i) {
        uint light = candidates[i];
        LightDepths reach = light_depths[light];
        if (reach.nearest_m > far_m || reach.farthest_m < near_m) continue;
        tile_entries[range.x + count] = light;
        ++count;
    }
    tile_ranges[tile] = uvec2(range.x, count);
    return count;
}

void main() {
    if (gl_LocalInvocationID.x == 0u) {
        nearest_depth = 0u;
        farthest_depth = 0xffffffffu;
    }
    barrier();
    find_depths(gl_WorkGroupID.xy);
    barrier();
    if (gl_LocalInvocationID.x != 0u || nearest_depth == 0u) return;
    uint tile = gl_WorkGroupID.y * tile_grid.cells.x + gl_WorkGroupID.x;
    uint kind = list_lights(tile) == 0u ? k_tile_class_sky_lit : k_tile_class_lamp_lit;
    uint place = atomicAdd(tile_draws[kind].tile_count, 1u);
    class_tiles[kind * tile_grid.cells.x * tile_grid.cells.y + place] = tile;
}
