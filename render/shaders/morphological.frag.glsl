// Morphological anti-aliasing: our implementation of the method of Reshetov 2009 with the edges of Jimenez et al. 2012.
// Edges between pixels form lines. Where other edges leave a line's ends, it is a stair of a silhouette, and the areas that
// this cuts from the pixels beside the line are mixed into them. In one pass: a pixel looks along the line on each of its
// four sides. Diagonals and sharp corners have no patterns of their own. Define QUALITY: 0 low, 1 medium, 2 high.
#include "render/shaders/shared/bindings.h"

layout(binding = UNIT_PASS) uniform sampler2D display;
layout(binding = UNIT_PASS + 3) uniform usampler2D edges;

/// Of four pixels, this one's own first: on either hand at least 4 pixels are seen, 12, or 28.
const int k_words_of_quality[3] = int[](2, 4, 8);
const int k_words = k_words_of_quality[QUALITY];

#include "line_ends.glsl"
#include "line_area.glsl"

layout(location = 0) out vec4 out_colour;

/// @param place  on a line, of the pixel above it
/// @return       as line_areas()
vec2 areas_at(bool columns, ivec2 place) {
    LineEnd behind = line_end_behind(columns, place);
    LineEnd ahead = line_end_ahead(columns, place);
    float height_behind = end_height(behind.turns_up, behind.turns_down, ahead.turns_up, ahead.turns_down);
    float height_ahead = end_height(ahead.turns_up, ahead.turns_down, behind.turns_up, behind.turns_down);
    return line_areas(float(behind.passed_px), float(ahead.passed_px), height_behind, height_ahead);
}

/// Sides of a pixel: below, above, left, right. A line is kept by the pixel above it, or on its right: the sides above and
/// on the right are those of the pixel beyond.
bool is_column(int side) {
    return side >= 2;
}
bool is_beyond(int side) {
    return (side & 1) != 0;
}
ivec2 place_of(int side, ivec2 pixel) {
    return (is_column(side) ? pixel.yx : pixel) + ivec2(0, is_beyond(side) ? 1 : 0);
}

/// A bit for each side.
uint sides_with_lines(ivec2 pixel) {
    uint sides = 0u;
    for (int side = 0; side < 4; ++side)
        sides |= has_line(is_column(side), place_of(side, pixel)) ? 1u << uint(side) : 0u;
    return sides;
}

vec3 colour_at(ivec2 pixel) {
    return texelFetch(display, clamp(pixel, ivec2(0), textureSize(display, 0) - 1), 0).rgb;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint sides = sides_with_lines(pixel);
    if (sides == 0u) discard;
    // As many turns as the pixel has lines; most have one or two.
    vec4 shares = vec4(0.0);
    while (sides != 0u) {
        int side = findLSB(sides);
        sides &= sides - 1u;
        vec2 areas = areas_at(is_column(side), place_of(side, pixel));
        shares[side] = is_beyond(side) ? areas.y : areas.x;
    }
    // Of a corner, the longer side.
    bool vertical = max(shares.x, shares.y) >= max(shares.z, shares.w);
    vec2 mixed_in = vertical ? shares.xy : shares.zw;
    float sum = mixed_in.x + mixed_in.y;
    if (!(sum > 0.0)) discard;
    ivec2 across = vertical ? ivec2(0, 1) : ivec2(1, 0);
    vec3 own = colour_at(pixel);
    // Lines on both sides each have their part of the pixel.
    vec3 mixed = mixed_in.x * mix(own, colour_at(pixel - across), mixed_in.x) +
                 mixed_in.y * mix(own, colour_at(pixel + across), mixed_in.y);
    out_colour = vec4(mixed / sum, 1.0);
}
