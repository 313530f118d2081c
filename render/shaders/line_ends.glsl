// How far a line of edges goes from a pixel, and how it ends. Includers declare `edges`, the texture of words that
// line_bits.glsl describes, and k_words, tiles that a search looks at. Places on a line are (along, across): (x, y) on lines
// along rows, (y, x) on lines along columns. Searches are loops of unknown length: others are unrolled, and where
// branches do not save work, they take their full length for every pixel.
#include "line_bits.glsl"

/// The rim of a line's stretch of edges.
struct LineEnd {
    int passed_px;   ///< pixels between this one and the end
    bool turns_up;   ///< an edge leaves the line there, on the side of its own pixels
    bool turns_down; ///< on the other side
};

/// A tile's bits of one direction; none outside of the picture.
uint line_word(bool columns, ivec2 tile) {
    ivec2 place = columns ? tile.yx : tile;
    if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, textureSize(edges, 0)))) return 0u;
    uvec2 words = texelFetch(edges, place, 0).xy;
    return columns ? words.y : words.x;
}

/// Edges of one line (x), and what crosses it above (y) and below (z), of a tile: four bits of each.
uvec3 line_bits(bool columns, int tile_along, int across) {
    uint above = line_word(columns, ivec2(tile_along, across >> 2)) >> uint(4 * (across & 3));
    int beneath = across - 1;
    uint below = line_word(columns, ivec2(tile_along, beneath >> 2)) >> uint(4 * (beneath & 3));
    return uvec3(above >> k_half_word, above, below) & k_row_mask;
}

bool has_bit(uint bits, int place) {
    return (bits >> uint(place) & 1u) != 0u;
}

bool has_line(bool columns, ivec2 place) {
    uint word = line_word(columns, place >> 2);
    return has_bit(word, int(k_half_word) + 4 * (place.y & 3) + (place.x & 3));
}

/// To the right, or up. The line ends before the first pixel that has no such edge, or at whose near side it is crossed.
LineEnd line_end_ahead(bool columns, ivec2 place) {
    int next = place.x + 1;
    int limit = (place.x & ~3) + 4 * k_words;
    while (next < limit) {
        uvec3 bits = line_bits(columns, next >> 2, place.y);
        uint stops = (~bits.x | bits.y | bits.z) & (k_row_mask << uint(next & 3)) & k_row_mask;
        int first = next & ~3;
        if (stops != 0u) {
            int end = findLSB(stops);
            return LineEnd(first + end - place.x - 1, has_bit(bits.y, end), has_bit(bits.z, end));
        }
        next = first + 4;
    }
    return LineEnd(next - place.x - 1, false, false);
}

/// To the left, or down. The line ends at the first pixel at whose near side it is crossed, or before which there is no edge.
LineEnd line_end_behind(bool columns, ivec2 place) {
    int last = place.x;
    int limit = (place.x & ~3) - 4 * (k_words - 1);
    while (last >= limit) {
        uvec3 bits = line_bits(columns, last >> 2, place.y);
        uint seen = k_row_mask >> uint(3 - (last & 3));
        int first = last & ~3;
        // The boundary before pixel i of the tile is i; 4, after the last, was found uncrossed by the look before.
        int missing = findMSB(~bits.x & seen);
        int crossed = findMSB((bits.y | bits.z) & seen);
        if (missing >= 0 || crossed >= 0) {
            int end = max(missing + 1, crossed);
            bool within = end < 4;
            return LineEnd(place.x - first - end, within && has_bit(bits.y, end), within && has_bit(bits.z, end));
        }
        last = first - 1;
    }
    return LineEnd(place.x - last - 1, false, false);
}
