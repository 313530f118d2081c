// Which light glows.
#include "colour.glsl"

/// Luminance above the threshold t, with a soft knee of half width k: 0 up to t − k, Y − t from t + k on, and between
/// them the parabola (Y − (t − k))²/(4k), which meets both with their slopes.
/// @param levels  x: t − k, y: t + k, z: t
float glowing_luminance(float luminance_of_light, vec3 levels) {
    float above = luminance_of_light - levels.x;
    if (!(above > 0.0)) return 0.0;
    if (luminance_of_light < levels.y) return above * above / (2.0 * (levels.y - levels.x));
    return luminance_of_light - levels.z;
}

/// The part of a pixel's light that glows, in the pixel's own colour. Here what earlier passes left unsound becomes
/// numbers, before it can spread: NaN and negative channels count as 0, infinite ones as the largest half float.
vec3 glowing_light(vec3 scene, vec3 levels) {
    vec3 light = storable_radiance(scene);
    float y = luminance(light);
    float glowing = glowing_luminance(y, levels);
    return glowing > 0.0 ? light * (glowing / y) : vec3(0.0);
}

/// Luminance about which pixels begin to count less: twice what the glass of a street lamp shows at night.
const float k_firefly_luminance = 16.0;

/// Weight of a pixel among those that are averaged: a lone one, however bright, counts no more than one of the luminance
/// above, and where all are alike their mean is what it was. Karis 2013, "Tone mapping", with 1 for that luminance.
float firefly_weight(vec3 light) {
    return 1.0 / (1.0 + luminance(light) / k_firefly_luminance);
}
