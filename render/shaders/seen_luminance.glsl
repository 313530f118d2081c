// What a pixel adds to the average luminance of a picture.
#include "colour.glsl"

/// The largest half float: brighter light is not stored.
const float k_largest_half = 65504.0;
/// Exponent bits of a float, all of which are set in what is infinite or NaN.
const uint k_exponent = 0x7f800000u;

/// False for what is infinite or NaN, as the luminance of a pixel is of which one channel is. Asked of the bits: a
/// compiler may turn !(x <= y) into x > y, which NaN makes another question.
bool is_number(float y) {
    return (floatBitsToUint(y) & k_exponent) != k_exponent;
}

/// What a pixel counts as: its luminance in [0, k_largest_half]; 0 for what is no number, or below zero.
/// @param y  Rec. 709 luminance of the pixel
float seen_luminance(float y) {
    return is_number(y) && y > 0.0 ? min(y, k_largest_half) : 0.0;
}

/// Sum of the logarithms of four values in [1e-6, 65505]: of their product, which no float is too small or too
/// large for, since logarithms are dear.
float sum_of_logs(vec4 values) {
    return log(values.x * values.y * values.z * values.w);
}
