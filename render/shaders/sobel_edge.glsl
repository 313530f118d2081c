// How strongly a pixel is blurred by what the Sobel operator finds around it (Sobel and Feldman 1968). SOBEL_OF_DEPTH: 1
// where the nine values are depths.

/// Slopes per pixel, of luma or of depth in shares of the nearest of the nine, from which blurring begins, and at which it
/// is whole. A step between two flat areas counts half of its height.
#if SOBEL_OF_DEPTH
const float k_faint_slope = 0.02;
const float k_steep_slope = 0.08;
#else
const float k_faint_slope = 0.04;
const float k_steep_slope = 0.16;
#endif

/// @param nine  as in edge_criterion.glsl
/// @return      0 where the pixel stays as it is, up to 1
float sobel_weight(float nine[9]) {
    // Tiles are found by the same numbers in another program: exact, so that both decide alike.
    precise float across = nine[2] + 2.0 * nine[5] + nine[8] - nine[0] - 2.0 * nine[3] - nine[6];
    precise float upwards = nine[6] + 2.0 * nine[7] + nine[8] - nine[0] - 2.0 * nine[1] - nine[2];
    precise float squared = across * across + upwards * upwards;
    float scale = 8.0;  // of the operator: the weights of either side sum to 4, two pixels apart
#if SOBEL_OF_DEPTH
    float nearest = nine[0];
    for (int i = 1; i < 9; ++i) nearest = max(nearest, nine[i]);
    scale *= nearest;
#endif
    precise float faint = k_faint_slope * scale;
    precise float least = faint * faint;
    if (!(squared > least)) return 0.0;
    float between = clamp((sqrt(squared) / scale - k_faint_slope) / (k_steep_slope - k_faint_slope), 0.0, 1.0);
    return max(between, 1e-3);  // what is above the threshold is an edge, however rounded
}
