// Tiles of the screen that have edges to smooth: what edge_tiles.comp.glsl lists and edge_tile.vert.glsl
// draws.
#ifndef RAMBLA_SHARED_EDGE_TILES_H
#define RAMBLA_SHARED_EDGE_TILES_H

#include "render/shaders/shared/types.h"

// Tiles along either side of a workgroup that looks for edges. A macro, since it stands in a layout
// qualifier.
#define EDGE_TILES_OF_GROUP 8

SHARED_BEGIN

// Pixels along a tile's edge. Small, since edges are everywhere in a street and thin: of its pixels, 27 % lie
// at edges, 49 % in tiles of 4 that have any, 60 % in tiles of 8, 73 % in tiles of 16. And llvmpipe shades 4
// by 4.
SHARED_CONSTANT k_edge_tile_px = 4u;
// Bits for one of a tile's coordinates; the other one lies above.
SHARED_CONSTANT k_edge_tile_bits = 16u;

// As glDrawArraysIndirect takes it; heads the storage block of the tiles, std430. Each is drawn as a point.
struct EdgeTileDraw {
    uint tile_count;
    uint instance_count;
    uint first_vertex;
    uint base_instance;
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::EdgeTileDraw) == 16);
#endif
#endif
