// Tiles of the screen by what they call for: what light_tiles.comp.glsl finds, and the passes draw that are made for one
// class. TILE_ACCESS: readonly unless a shader defines it.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/light_cells.h"

#ifndef TILE_ACCESS
#define TILE_ACCESS readonly
#endif

layout(std430, binding = BINDING_PASS_STORAGE) TILE_ACCESS buffer TileBlock {
    TileDraw tile_draws[k_tile_classes];
    LightGrid tile_grid;
    uvec2 tile_ranges[];  ///< of tile_entries, by tile
};
layout(std430, binding = BINDING_PASS_STORAGE + 1) TILE_ACCESS buffer TileClassBlock {
    uint class_tiles[];  ///< the tiles of each class; a class begins at its number times the number of tiles
};
layout(std430, binding = BINDING_PASS_STORAGE + 2) TILE_ACCESS buffer TileEntryBlock {
    uint tile_entries[];  ///< rows of the frame's lights
};
