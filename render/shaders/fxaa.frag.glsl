// Fast approximate anti-aliasing: our implementation of the method of Lottes 2009, "FXAA" (NVIDIA white
// paper).
//
//   1. Where the luma of a pixel and its neighbours hardly differs, the pixel stays as it is.
//   2. An edge runs along rows or columns, whichever bends the luma more across it; it lies on the side of the
//      pixel where luma changes most.
//   3. Walking along that side, half way between the two pixel rows, the mean luma tells where the edge ends on
//      either hand. The nearer end and the length give how much of the pixel a straight edge would cover: the
//      pixel is sampled that far across it, by the bilinear filter.
//   4. Single pixels and thin lines have no ends to find; their contrast to the mean of all neighbours gives a
//      second offset. The larger of the two is taken.
#include "render/shaders/shared/bindings.h"

layout(binding = UNIT_PASS) uniform sampler2D display;  ///< linear filter; luma in alpha

in vec2 uv;
layout(location = 0) out vec4 out_colour;

/// Contrast below this share of the brightest neighbour, or below this luma, is texture and noise, not an
/// edge.
const float k_relative_threshold = 0.125;
const float k_absolute_threshold = 0.0312;
/// How strongly lone pixels are blurred: 0 not at all, 1 into the mean of their neighbours.
const float k_lone_pixel_strength = 0.75;
/// Distances of the search: fine near the pixel, where ends matter most, then in strides.
const int k_search_steps = 10;
const float k_strides[k_search_steps] = float[](1.0, 1.0, 1.0, 1.0, 1.5, 2.0, 2.0, 2.0, 4.0, 8.0);

float luma_at(vec2 place) {
    return textureLod(display, place, 0.0).a;
}

/// Distance from the pixel to the edge's end in one direction, and how the mean luma there differs from the
/// edge's own.
/// @param along  one texel along the edge
vec2 search_end(vec2 start, vec2 along, float edge_luma, float end_contrast) {
    float distance_px = 0.0;
    float difference = 0.0;
    for (int i = 0; i < k_search_steps; ++i) {
        distance_px += k_strides[i];
        difference = luma_at(start + along * distance_px) - edge_luma;
        if (abs(difference) >= end_contrast) break;
    }
    return vec2(distance_px, difference);
}

void main() {
    vec2 texel = 1.0 / vec2(textureSize(display, 0));
    vec4 centre = texelFetch(display, ivec2(gl_FragCoord.xy), 0);
    // A gather at a texel's corner holds (left, top), (right, top), (right, bottom), (left, bottom).
    vec4 upper_right = textureGather(display, uv + 0.5 * texel, 3);
    vec4 lower_left = textureGather(display, uv - 0.5 * texel, 3);
    float m = centre.a, n = upper_right.x, ne = upper_right.y, e = upper_right.z;
    float w = lower_left.x, sw = lower_left.w, s = lower_left.z;
    float nw = luma_at(uv + vec2(-texel.x, texel.y)), se = luma_at(uv + vec2(texel.x, -texel.y));

    float brightest = max(m, max(max(n, s), max(e, w)));
    float darkest = min(m, min(min(n, s), min(e, w)));
    float contrast = brightest - darkest;
    if (contrast < max(k_absolute_threshold, brightest * k_relative_threshold)) {
        out_colour = vec4(centre.rgb, 1.0);
        return;
    }

    float bend_across_rows = abs(nw - 2.0 * w + sw) + 2.0 * abs(n - 2.0 * m + s) + abs(ne - 2.0 * e + se);
    float bend_across_columns = abs(nw - 2.0 * n + ne) + 2.0 * abs(w - 2.0 * m + e) + abs(sw - 2.0 * s + se);
    bool along_row = bend_across_rows >= bend_across_columns;
    vec2 along = along_row ? vec2(texel.x, 0.0) : vec2(0.0, texel.y);
    vec2 across = along_row ? vec2(0.0, texel.y) : vec2(texel.x, 0.0);
    float ahead = along_row ? n : e;
    float behind = along_row ? s : w;
    bool edge_ahead = abs(ahead - m) >= abs(behind - m);
    float neighbour = edge_ahead ? ahead : behind;
    across = edge_ahead ? across : -across;

    vec2 start = uv + 0.5 * across;
    float edge_luma = 0.5 * (m + neighbour);
    float end_contrast = 0.25 * abs(neighbour - m);
    vec2 forwards = search_end(start, along, edge_luma, end_contrast);
    vec2 backwards = search_end(start, -along, edge_luma, end_contrast);
    vec2 nearer = forwards.x < backwards.x ? forwards : backwards;
    // Only where the edge's end turns towards this pixel's side does a straight edge cut this pixel.
    bool cuts_this_pixel = (nearer.y < 0.0) != (m - edge_luma < 0.0);
    float edge_offset = cuts_this_pixel ? 0.5 - nearer.x / (forwards.x + backwards.x) : 0.0;

    float mean = (2.0 * (n + s + e + w) + nw + ne + sw + se) / 12.0;
    float lone = clamp(abs(mean - m) / contrast, 0.0, 1.0);
    float smooth_lone = lone * lone * (3.0 - 2.0 * lone);
    float offset = max(edge_offset, smooth_lone * smooth_lone * k_lone_pixel_strength);
    out_colour = vec4(textureLod(display, uv + across * offset, 0.0).rgb, 1.0);
}
