// Blurs the picture at edges: sobel and edges. How much, is how far four look-ups are moved from the pixel's centre
// (Shishkovtsov 2005, GPU Gems 2, ch. 9). Defines: as in edge_sources.glsl and edge_criterion.glsl.
#include "edge_sources.glsl"
#include "edge_criterion.glsl"

layout(location = 0) out vec4 out_colour;

/// A quarter of a pixel gives neighbours an eighth of the weight across a straight edge: what is nearest, in the mean
/// of squares, to the share of each pixel that the edge covers.
const float k_reach_px = 0.25;
/// A straight edge breaks three lines, a corner two at least.
const float k_lines_of_an_edge = 2.0;

float blur_weight(vec2 uv, vec2 texel) {
    float nine[9];
    gather_neighbours(uv, texel, nine);
#if SOBEL
    return sobel_weight(nine);
#else
    float found = broken_lines(nine);
#if NORMALS
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    found += turned_normals(source_normal(pixel), source_normal(pixel + ivec2(0, 1)),
                            source_normal(pixel - ivec2(0, 1)), source_normal(pixel + ivec2(1, 0)),
                            source_normal(pixel - ivec2(1, 0)));
#endif
    return min(found / k_lines_of_an_edge, 1.0);
#endif
}

void main() {
    vec2 texel = 1.0 / vec2(textureSize(display, 0));
    vec2 uv = gl_FragCoord.xy * texel;
    float weight = blur_weight(uv, texel);
    if (!(weight > 0.0)) discard;
    vec2 reach = weight * k_reach_px * texel;
    vec3 sum = textureLod(display, uv + reach, 0.0).rgb + textureLod(display, uv - reach, 0.0).rgb +
               textureLod(display, uv + vec2(reach.x, -reach.y), 0.0).rgb +
               textureLod(display, uv + vec2(-reach.x, reach.y), 0.0).rgb;
    out_colour = vec4(0.25 * sum, 1.0);
}
