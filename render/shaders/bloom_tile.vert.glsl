// One quad for each listed tile, as a strip of vertices 0…3. Define DRAW: k_bloom_draw_bright, in texels of the bright
// light and one of them wider on each side, as far as a tile's pixels reach; or k_bloom_draw_visible, in pixels.
#include "bloom_tiles.glsl"

void main() {
    uint list = DRAW == k_bloom_draw_visible ? bloom.tiles.x * bloom.tiles.y : 0u;
    uint tile = bloom_tiles[list + uint(gl_InstanceID)];
    vec2 cell = vec2(tile % bloom.tiles.x, tile / bloom.tiles.x);
    vec2 side = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 size = vec2(bloom.size_px.xy);
    vec2 corner = (cell + side) * float(bloom.tiles.z);
    if (DRAW == k_bloom_draw_bright) {
        float texel_px = float(bloom.tiles.w);
        size = ceil(size / texel_px);
        corner = corner / texel_px + 2.0 * side - 1.0;
    }
    gl_Position = vec4(2.0 * clamp(corner, vec2(0.0), size) / size - 1.0, 0.0, 1.0);
}
