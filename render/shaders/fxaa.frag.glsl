// Fast approximate anti-aliasing: our implementation of the method of Lottes 2009, "FXAA" (NVIDIA white
// paper).
//
//   1. Where the luma of a pixel and its neighbours hardly differs, the pixel stays as it is.
//   2. An edge runs along rows or columns, whichever bends the luma more across it; it lies on the side of the
//      pixel where luma changes most.
//   3. Walking along that side, between the two pixel rows, their mean luma tells where the edge ends on either
//      hand. The nearer end and the length give how much of the pixel a straight edge would cover: so much of
//      the pixel across it is mixed in.
//   4. Single pixels and thin lines have no ends to find; their contrast to the mean of all neighbours gives a
//      second share. The larger of the two is taken.
// Define QUALITY: as in fxaa_edge.glsl.
#include "render/shaders/shared/bindings.h"
#include "fxaa_edge.glsl"

layout(binding = UNIT_PASS) uniform sampler2D display;  ///< luma in alpha

layout(location = 0) out vec4 out_colour;

/// How strongly lone pixels are blurred: 0 not at all, 1 into the mean of their neighbours.
const float k_lone_pixel_strength = 0.75;
/// Looks for an end, of two pixels each: at first at every pixel, near the pixel where ends matter most, then at two
/// of four.
const int k_looks[3] = int[](3, 5, 8);
const int k_dense_looks[3] = int[](3, 3, 6);

float luma_at(ivec2 pixel) {
    return texelFetch(display, clamp(pixel, ivec2(0), textureSize(display, 0) - 1), 0).a;
}

/// Distance from the pixel to the edge's end in one direction, and how the sum of both rows' lumas there differs from the
/// edge's own.
/// @param place      corner between the first two pixels after this one and their neighbours across the edge
/// @param along      one texel in the direction of the search
/// @param backwards  that direction is left or down
vec2 search_end(vec2 place, vec2 along, bool along_row, bool backwards, float edge_sum, float end_contrast) {
    vec2 end = vec2(0.0);
    float start_px = 1.0;
    for (int i = 0; i < k_looks[QUALITY]; ++i) {
        // (left, top), (right, top), (right, bottom), (left, bottom)
        vec4 lumas = textureGather(display, place + along * (start_px - 1.0), 3);
        vec2 sums = along_row ? vec2(lumas.w + lumas.x, lumas.z + lumas.y)
                              : vec2(lumas.w + lumas.z, lumas.x + lumas.y);
        vec2 differences = (backwards ? sums.yx : sums) - edge_sum;
        bool at_first = abs(differences.x) >= end_contrast;
        end = at_first ? vec2(start_px, differences.x) : vec2(start_px + 1.0, differences.y);
        if (abs(end.y) >= end_contrast) break;
        start_px += i + 1 < k_dense_looks[QUALITY] ? 2.0 : 4.0;
    }
    return end;
}

void main() {
    vec2 texel = 1.0 / vec2(textureSize(display, 0));
    vec2 uv = gl_FragCoord.xy * texel;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // A gather at a texel's corner holds (left, top), (right, top), (right, bottom), (left, bottom).
    vec4 upper_right = textureGather(display, uv + 0.5 * texel, 3);
    vec4 lower_left = textureGather(display, uv - 0.5 * texel, 3);
    float m = upper_right.w, n = upper_right.x, ne = upper_right.y, e = upper_right.z;
    float w = lower_left.x, sw = lower_left.w, s = lower_left.z;
    vec2 contrast = fxaa_contrast(m, n, s, e, w);
    if (!is_fxaa_edge(contrast)) discard;

    float nw = luma_at(pixel + ivec2(-1, 1)), se = luma_at(pixel + ivec2(1, -1));
    float bend_across_rows = abs(nw - 2.0 * w + sw) + 2.0 * abs(n - 2.0 * m + s) + abs(ne - 2.0 * e + se);
    float bend_across_columns = abs(nw - 2.0 * n + ne) + 2.0 * abs(w - 2.0 * m + e) + abs(sw - 2.0 * s + se);
    bool along_row = bend_across_rows >= bend_across_columns;
    float ahead = along_row ? n : e;
    float behind = along_row ? s : w;
    bool edge_ahead = abs(ahead - m) >= abs(behind - m);
    float neighbour = edge_ahead ? ahead : behind;
    ivec2 across = (along_row ? ivec2(0, 1) : ivec2(1, 0)) * (edge_ahead ? 1 : -1);
    vec2 along = along_row ? vec2(texel.x, 0.0) : vec2(0.0, texel.y);

    vec2 side = uv + 0.5 * vec2(across) * texel;
    float edge_sum = m + neighbour;
    float end_contrast = 0.5 * abs(neighbour - m);
    vec2 forwards = search_end(side + 1.5 * along, along, along_row, false, edge_sum, end_contrast);
    vec2 backwards = search_end(side - 1.5 * along, -along, along_row, true, edge_sum, end_contrast);
    vec2 nearer = forwards.x < backwards.x ? forwards : backwards;
    // Only where the edge's end turns towards this pixel's side does a straight edge cut this pixel.
    bool cuts_this_pixel = (nearer.y < 0.0) != (m < neighbour);
    float edge_share = cuts_this_pixel ? 0.5 - nearer.x / (forwards.x + backwards.x) : 0.0;

    float mean = (2.0 * (n + s + e + w) + nw + ne + sw + se) / 12.0;
    float lone = clamp(abs(mean - m) / contrast.x, 0.0, 1.0);
    float smooth_lone = lone * lone * (3.0 - 2.0 * lone);
    float share = max(edge_share, smooth_lone * smooth_lone * k_lone_pixel_strength);
    vec3 own = texelFetch(display, pixel, 0).rgb;
    vec3 other = texelFetch(display, clamp(pixel + across, ivec2(0), textureSize(display, 0) - 1), 0).rgb;
    out_colour = vec4(mix(own, other, share), 1.0);
}
