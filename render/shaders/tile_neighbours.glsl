// Asks about each pixel of a tile whether it is at an edge, for methods that see its eight neighbours.
#include "edge_sources.glsl"
#include "edge_criterion.glsl"

/// A tile and the pixels around it.
const int k_side = int(k_edge_tile_px) + 2;

/// From one texel left of and below the tile on; outside of the picture, its border goes on.
void gather_tile(ivec2 tile, out float texels[k_side * k_side]) {
    vec2 texel = 1.0 / vec2(textureSize(display, 0));
    // A gather at the corner between four texels.
    vec2 corner = vec2(tile) * float(k_edge_tile_px);
    for (int y = 0; y < k_side; y += 2) {
        for (int x = 0; x < k_side; x += 2) {
            vec4 four = gather_source((corner + vec2(x, y)) * texel);
            texels[y * k_side + x] = four.w;
            texels[y * k_side + x + 1] = four.z;
            texels[(y + 1) * k_side + x] = four.x;
            texels[(y + 1) * k_side + x + 1] = four.y;
        }
    }
}

#if EDGES && NORMALS
bool tile_has_turn(ivec2 tile) {
    ivec2 first = tile * int(k_edge_tile_px) - 1;
    vec3 normals[k_side * k_side];
    for (int y = 0; y < k_side; ++y)
        for (int x = 0; x < k_side; ++x) normals[y * k_side + x] = source_normal(first + ivec2(x, y));
    bool any_turn = false;
    for (int y = 1; y < k_side - 1; ++y) {
        for (int x = 1; x < k_side - 1; ++x) {
            int i = y * k_side + x;
            float turns = turned_normals(normals[i], normals[i + k_side], normals[i - k_side], normals[i + 1],
                                         normals[i - 1]);
            any_turn = any_turn || turns > 0.0;
        }
    }
    return any_turn;
}
#endif

bool tile_has_edge(ivec2 tile) {
    float texels[k_side * k_side];
    gather_tile(tile, texels);
    bool any_edge = false;
    for (int y = 0; y < int(k_edge_tile_px); ++y) {
        for (int x = 0; x < int(k_edge_tile_px); ++x) {
            float nine[9];
            for (int i = 0; i < 9; ++i) nine[i] = texels[(y + i / 3) * k_side + x + i % 3];
            any_edge = any_edge || is_edge(nine);
        }
    }
#if EDGES && NORMALS
    return any_edge || tile_has_turn(tile);
#else
    return any_edge;
#endif
}
