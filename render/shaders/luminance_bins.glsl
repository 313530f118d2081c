#include "render/shaders/shared/luminance.h"

/// log2 of the luminance at the first bin's lower end and at the last one's upper end: δ is at least 1e-6, and half
/// floats end at 2^16.
const float k_bins_begin = -20.0;
const float k_bins_end = 16.0;
const float k_bins_per_stop = float(k_luminance_bins) / (k_bins_end - k_bins_begin);

/// @param y  luminance > 0
uint bin_of(float y) {
    float place = (log2(y) - k_bins_begin) * k_bins_per_stop;
    return uint(clamp(place, 0.0, float(k_luminance_bins - 1u)));
}

/// log2 of the luminance in a bin's middle.
float log2_of_bin(uint bin) {
    return k_bins_begin + (float(bin) + 0.5) / k_bins_per_stop;
}
