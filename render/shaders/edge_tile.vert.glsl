// One point for each listed tile, as large as the tile. The viewport covers whole tiles. Quads would be shaded twice
// where their two triangles meet, and instances of them are drawn one by one.
#include "edge_tiles.glsl"

layout(binding = UNIT_PASS) uniform sampler2D display;

void main() {
    uint listed = edge_tiles[gl_VertexID];
    uvec2 tile = uvec2(listed & ((1u << k_edge_tile_bits) - 1u), listed >> k_edge_tile_bits);
    vec2 centre = (vec2(tile) + 0.5) / vec2(edge_tile_grid(textureSize(display, 0)));
    gl_Position = vec4(2.0 * centre - 1.0, 0.0, 1.0);
    gl_PointSize = float(k_edge_tile_px);
}
