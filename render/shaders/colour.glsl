#include "constants.glsl"

/// Rec. 709 luminance of linear light.
float luminance(vec3 linear_light) {
    return dot(linear_light, vec3(0.2126, 0.7152, 0.0722));
}

/// Radiance as a half float can hold it: NaN and negative values become 0, overflow and infinity saturate.
/// The comparison is false for NaN, which is the point of writing it so.
vec3 storable_radiance(vec3 radiance) {
    return mix(vec3(0.0), min(radiance, vec3(k_max_radiance)), greaterThan(radiance, vec3(0.0)));
}

/// Linear light in [0, 1] to sRGB. The power segment 1.055·x^(1/2.4) − 0.055 is a minimax fit in x^(1/2),
/// x^(1/4), x^(1/8) and x (Lawson's iteration, 300 points in geometric progression): off by at most 0.0113/255,
/// without the pow that a software rasteriser is slow at. Ends are exact: 0 maps to 0, and 1 to 1 after the clamp.
vec3 encode_srgb(vec3 linear_light) {
    vec3 x = clamp(linear_light, 0.0, 1.0);
    vec3 root2 = sqrt(x);
    vec3 root4 = sqrt(root2);
    vec3 root8 = sqrt(root4);
    vec3 power = 0.64236556 * root2 + 0.71211055 * root4 - 0.33686998 * root8 - 0.01756309 * x;
    return min(mix(power, 12.92 * x, lessThanEqual(x, vec3(0.0031308))), vec3(1.0));
}

/// sRGB in [0, 1] to linear light. The power segment ((x + 0.055)/1.055)^2.4 is a weighted minimax fit (Lawson's
/// iteration, 601 points): off by at most 0.06 of the step between two neighbouring bytes. 1 maps to 1.
vec3 decode_srgb(vec3 encoded) {
    vec3 x = clamp(encoded, 0.0, 1.0);
    vec3 power = 0.00106033 + x * (0.02796887 + x * (0.56375541 + x * (0.51839961 - x * 0.11118422)));
    return mix(power, x / 12.92, lessThanEqual(x, vec3(0.04045)));
}

/// Interleaved gradient noise, [0, 1): every 3×3 neighbourhood holds nearly uniform values.
/// Jimenez 2014, "Next generation post processing in Call of Duty: Advanced Warfare".
float interleaved_gradient_noise(vec2 pixel) {
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

/// Adds ±½ of an 8-bit step, so that gradients do not band: the mean over pixels is what was asked for.
vec3 dither_8bit(vec3 encoded, vec2 pixel) {
    return encoded + (interleaved_gradient_noise(floor(pixel)) - 0.5) / 255.0;
}
