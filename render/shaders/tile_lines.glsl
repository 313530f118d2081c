// Finds where luma differs from the pixels to the left and below, for the morphological method, and keeps it as bits, a
// texel for each tile: a search for the end of a line then passes four pixels at a time. Thresholds and local adaptation
// after Jimenez et al. 2012, "SMAA: Enhanced subpixel morphological antialiasing". Define QUALITY.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/edge_tiles.h"
#include "line_bits.glsl"

layout(binding = UNIT_PASS) uniform sampler2D display;  ///< luma in alpha
layout(rg32ui, binding = 0) writeonly uniform uimage2D edges;

/// Differences of luma below these are no edges: low, medium and high quality of the paper's own presets.
const float k_thresholds[3] = float[](0.15, 0.1, 0.05);
/// Of the largest difference beside it, an edge has at least this share: a faint one beside a strong one is no edge that
/// is seen, and would cut the strong one's line in two.
const float k_share_of_largest = 0.5;

const int k_tile = int(k_edge_tile_px);
/// Two texels before the tile, two after it.
const int k_before = 2;
const int k_side = k_tile + 4;

float luma(float lumas[k_side * k_side], int x, int y) {
    return lumas[(y + k_before) * k_side + x + k_before];
}

void gather_lumas(ivec2 tile, out float lumas[k_side * k_side]) {
    vec2 texel = 1.0 / vec2(textureSize(display, 0));
    vec2 corner = vec2(tile * k_tile - k_before + 1);
    for (int y = 0; y < k_side; y += 2) {
        for (int x = 0; x < k_side; x += 2) {
            vec4 four = textureGather(display, (corner + vec2(x, y)) * texel, 3);
            lumas[y * k_side + x] = four.w;
            lumas[y * k_side + x + 1] = four.z;
            lumas[(y + 1) * k_side + x] = four.x;
            lumas[(y + 1) * k_side + x + 1] = four.y;
        }
    }
}

/// Whether a pixel has an edge on its left (x) and below (y).
bvec2 edges_of(float lumas[k_side * k_side], int x, int y) {
    float m = luma(lumas, x, y);
    float left = luma(lumas, x - 1, y), below = luma(lumas, x, y - 1);
    vec2 difference = abs(m - vec2(left, below));
    vec2 opposite = abs(m - vec2(luma(lumas, x + 1, y), luma(lumas, x, y + 1)));
    vec2 next = abs(vec2(left - luma(lumas, x - 2, y), below - luma(lumas, x, y - 2)));
    vec2 largest = max(max(difference, opposite), next);
    float least = max(k_thresholds[QUALITY], k_share_of_largest * max(largest.x, largest.y));
    return greaterThanEqual(difference, vec2(least));
}

bool tile_has_edge(ivec2 tile) {
    float lumas[k_side * k_side];
    gather_lumas(tile, lumas);
    ivec2 inside = textureSize(display, 0) - tile * k_tile;
    uint left = 0u, below = 0u;
    bool beyond = false;
    for (int y = 0; y <= k_tile; ++y) {
        for (int x = 0; x <= k_tile; ++x) {
            // The pixel after the last has its edges in another tile's bits, but they change this one's pixels.
            bvec2 found = edges_of(lumas, x, y);
            bool exists = x < inside.x && y < inside.y;
            if (x < k_tile && y < k_tile) {
                left |= found.x && exists ? line_bit(x, y) : 0u;
                below |= found.y && exists ? line_bit(x, y) : 0u;
            } else if (x == k_tile && y < k_tile) {
                beyond = beyond || (found.x && exists);
            } else if (y == k_tile && x < k_tile) {
                beyond = beyond || (found.y && exists);
            }
        }
    }
    imageStore(edges, tile, uvec4(packed_lines(left, below), 0u, 0u));
    return (left | below) != 0u || beyond;
}
