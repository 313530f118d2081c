// Where FXAA sees an edge. Define QUALITY: 0 low, 1 medium, 2 high.

/// Contrast below this share of the brightest neighbour, or below this luma, is texture and noise, not an edge: what
/// Lottes 2009 calls low quality, the default, and high quality; and the limits of what is seen, of what is
/// seen where it is not smoothed, and between.
const float k_relative_thresholds[3] = float[](0.25, 0.166, 0.125);
const float k_absolute_thresholds[3] = float[](0.0833, 0.0625, 0.0312);

/// Of the lumas of a pixel and the four beside it: x the largest difference, y the largest of them.
vec2 fxaa_contrast(float m, float n, float s, float e, float w) {
    float brightest = max(m, max(max(n, s), max(e, w)));
    float darkest = min(m, min(min(n, s), min(e, w)));
    return vec2(brightest - darkest, brightest);
}

bool is_fxaa_edge(vec2 contrast) {
    return contrast.x >= max(k_absolute_thresholds[QUALITY], contrast.y * k_relative_thresholds[QUALITY]);
}
