// The list of tiles that have edges to smooth. EDGE_TILE_ACCESS: readonly unless a shader defines it.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/edge_tiles.h"

#ifndef EDGE_TILE_ACCESS
#define EDGE_TILE_ACCESS readonly
#endif

layout(std430, binding = BINDING_PASS_STORAGE) EDGE_TILE_ACCESS buffer EdgeTileBlock {
    EdgeTileDraw edge_tile_draw;
    uint edge_tiles[];  ///< x, and y from bit k_edge_tile_bits on
};

uvec2 edge_tile_grid(ivec2 size_px) {
    return (uvec2(size_px) + k_edge_tile_px - 1u) / k_edge_tile_px;
}
