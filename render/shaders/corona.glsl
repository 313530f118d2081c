// What an eye makes of a point of light. Spencer, Shirley, Zimmerman and Greenberg 1995, "Physically-Based Glare Effects
// for Digital Images": parts of the point-spread function of a dark-adapted eye, per steradian, by the angle in degrees.
#include "constants.glsl"

/// Shares of what such an eye scatters that are drawn: eyes that look at a display scatter its light as well, and a ring
/// of colours as strong as in the dark would be the first thing to be seen.
const float k_needle_share = 0.1;
const float k_halo_share = 0.012;
/// Angle from a lamp up to which its corona is drawn.
const float k_corona_deg = 5.0;

/// The ciliary corona, light on the fibres of the lens: 0.478·20.91/(θ + 0.02)³ on average over its needles.
/// @param lamp_deg  how large the lamp is seen, within which its light is spread
float corona_needles(float angle_deg, float lamp_deg) {
    float spread_deg = angle_deg + lamp_deg + 0.02;
    return k_needle_share * 0.478 * 20.91 / (spread_deg * spread_deg * spread_deg);
}

/// The lenticular halo, a ring that is wider for red than for blue: 0.033·436.9·(568/λ)·exp(−19.75·(θ − 3·λ/568)²) at
/// 611, 549 and 464 nm, where the primaries of Rec. 709 dominate.
vec3 corona_halo(float angle_deg) {
    const vec3 wavelength = vec3(611.0, 549.0, 464.0) / 568.0;
    vec3 off_deg = angle_deg - 3.0 * wavelength;
    return k_halo_share * 0.033 * 436.9 / wavelength * exp(-19.75 * off_deg * off_deg);
}

/// A number from 0 to 1 for each whole number.
float needle_length(float needle) {
    return fract(sin(needle * 12.9898) * 43758.5453);
}

/// Needles around, as many as pixels tell apart, each brightest along its middle; 1 on average over all directions.
/// @param turn  direction, whole turns
float corona_rays(float turn) {
    const float needles = 44.0;
    float place = fract(turn) * needles;
    float needle = floor(place);
    float across = 2.0 * (place - needle) - 1.0;
    float narrow = 1.0 - across * across;
    // The mean of (1 − x²)² is 8/15, and that of the squared lengths a third.
    float bright = needle_length(needle);
    return narrow * narrow * bright * bright * 3.0 * 15.0 / 8.0;
}
