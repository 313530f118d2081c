#include "colour.glsl"

/// Scene luminances between which cones take over from rods, 2.6 decades as Jensen et al. 2000 ("Night rendering") have
/// them. Theirs are 0.01 and 4 cd/m²; nights of generated places are as much brighter than nature's as photographs show
/// them, and so are these.
const float k_rods_alone = 5e-4;
const float k_cones_alone = 0.2;

/// Linear light of luminance 1 and chromaticity (0.25, 0.25), the blue that Jensen et al. give to what rods see.
const vec3 k_night_blue = vec3(0.7062, 0.9899, 1.9657);

/// What rods see: V = Y·(1.33·(1 + (Y + Z)/X) − 1.68), Larson et al. 1997; divided by what that is for white, so that
/// greys are as bright as before, reds darker and blues brighter (Purkinje).
float rod_luminance(vec3 colour) {
    float x = dot(colour, vec3(0.4124, 0.3576, 0.1805));
    float y = luminance(colour);
    float z = dot(colour, vec3(0.0193, 0.1192, 0.9505));
    const float k_of_white = 2.573;
    return x > 0.0 ? max(y * (1.33 * (1.0 + (y + z) / x) - 1.68), 0.0) / k_of_white : 0.0;
}

/// @param colour    exposed scene light
/// @param exposure  its exposure, so that the same things look alike at any
/// @param amount    0: cones see everything; 1: rods what is dark
vec3 seen_by_night(vec3 colour, float exposure, float amount) {
    float decades = log2(max(luminance(colour) / exposure, 1e-12) / k_rods_alone) /
                    log2(k_cones_alone / k_rods_alone);
    float rods = 1.0 - smoothstep(0.0, 1.0, decades);
    return mix(colour, rod_luminance(colour) * k_night_blue, amount * rods);
}
