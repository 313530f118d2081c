// What a pixel's eight neighbours say about an edge at it, in the value that the method compares. Neighbourhoods are
// arrays of nine, row by row from the lower left corner; [4] is the pixel's own.
// Defines: FXAA, SOBEL or EDGES.
#if FXAA
#include "fxaa_edge.glsl"
bool is_edge(float nine[9]) {
    return is_fxaa_edge(fxaa_contrast(nine[4], nine[7], nine[1], nine[5], nine[3]));
}
#elif SOBEL
#include "sobel_edge.glsl"
bool is_edge(float nine[9]) {
    return sobel_weight(nine) > 0.0;
}
#elif EDGES
#include "broken_lines.glsl"
bool is_edge(float nine[9]) {
    return broken_lines(nine) > 0.0;
}
#endif
