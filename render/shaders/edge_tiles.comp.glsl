// Lists the tiles in which a method of anti-aliasing would change a pixel, one invocation for each: it gathers what the
// method looks for edges in, four texels at a time, once for all pixels of the tile, and asks the method about each.
// Defines: FXAA, SOBEL, EDGES or MORPHOLOGICAL, and what those want.
#define EDGE_TILE_ACCESS
#include "edge_tiles.glsl"
#if MORPHOLOGICAL
#include "tile_lines.glsl"
#else
#include "tile_neighbours.glsl"
#endif

layout(local_size_x = EDGE_TILES_OF_GROUP, local_size_y = EDGE_TILES_OF_GROUP) in;

void main() {
    uvec2 tile = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(tile, edge_tile_grid(textureSize(display, 0))))) return;
    if (!tile_has_edge(ivec2(tile))) return;
    uint place = atomicAdd(edge_tile_draw.tile_count, 1u);
    edge_tiles[place] = tile.x | tile.y << k_edge_tile_bits;
}
