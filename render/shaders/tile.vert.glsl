// One quad for each tile of a class, as a strip of vertices 0…3, at infinity: a depth test of GL_LESS keeps the pixels
// that show geometry. Define TILE_CLASS.
#include "frame.glsl"
#include "tiles.glsl"

flat out uvec2 tile_range;

void main() {
    uint tiles = tile_grid.cells.x * tile_grid.cells.y;
    uint tile = class_tiles[TILE_CLASS * tiles + uint(gl_InstanceID)];
    uvec2 cell = uvec2(tile % tile_grid.cells.x, tile / tile_grid.cells.x);
    uvec2 corner = (cell + uvec2(gl_VertexID & 1, gl_VertexID >> 1)) * tile_grid.cells.w;
    vec2 pixel = min(vec2(corner), frame.size_px.xy);
    gl_Position = vec4(2.0 * pixel * frame.size_px.zw - 1.0, 0.0, 1.0);
    tile_range = tile_ranges[tile];
}
