// Morphological anti-aliasing: our implementation of the method of Reshetov 2009 with the edges of Jimenez et al. 2012.
// Edges between pixels form lines. Where other edges leave a line's ends, it is a stair of a silhouette, and the areas that
// this cuts from the pixels beside the line are mixed into them. In one pass: a pixel looks along the line on each of its
// four sides. Diagonals and sharp corners have no patterns of their own. Define QUALITY: 0 low, 1 medium, 2 high.
#include "render/shaders/shared/bindings.h"

layout(binding = UNIT_PASS) uniform sampler2D display;
layout(binding = UNIT_PASS + 3) uniform usampler2D edges;

/// Of four pixels: 5 to 8 pixels on either hand, 13 to 16, or 29 to 32.
const int k_words_of_quality[3] = int[](2, 4, 8);
const int k_words = k_words_of_quality[QUALITY];

#include "line_ends.glsl"
#include "line_area.glsl"

layout(location = 0) out vec4 out_colour;

/// @param place  on a line, of the pixel above it
/// @return       as line_areas(), 0 where there is no line
vec2 areas_at(bool columns, ivec2 place) {
    if (!has_bit(line_bits(columns, place.x >> 2, place.y).x, place.x & 3)) return vec2(0.0);
    LineEnd behind = line_end_behind(columns, place);
    LineEnd ahead = line_end_ahead(columns, place);
    float height_behind = end_height(behind.turns_up, behind.turns_down, ahead.turns_up, ahead.turns_down);
    float height_ahead = end_height(ahead.turns_up, ahead.turns_down, behind.turns_up, behind.turns_down);
    return line_areas(float(behind.passed_px), float(ahead.passed_px), height_behind, height_ahead);
}

vec3 colour_at(ivec2 pixel) {
    return texelFetch(display, clamp(pixel, ivec2(0), textureSize(display, 0) - 1), 0).rgb;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float from_below = areas_at(false, pixel).x;
    float from_above = areas_at(false, pixel + ivec2(0, 1)).y;
    float from_left = areas_at(true, pixel.yx).x;
    float from_right = areas_at(true, pixel.yx + ivec2(0, 1)).y;
    // Of a corner, the longer side.
    bool vertical = max(from_below, from_above) >= max(from_left, from_right);
    vec2 shares = vertical ? vec2(from_below, from_above) : vec2(from_left, from_right);
    float sum = shares.x + shares.y;
    if (!(sum > 0.0)) discard;
    ivec2 across = vertical ? ivec2(0, 1) : ivec2(1, 0);
    vec3 own = colour_at(pixel);
    // Lines on both sides each have their part of the pixel.
    vec3 mixed = shares.x * mix(own, colour_at(pixel - across), shares.x) +
                 shares.y * mix(own, colour_at(pixel + across), shares.y);
    out_colour = vec4(mixed / sum, 1.0);
}
