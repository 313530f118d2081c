#include "colour.glsl"

/// A colour of another luminance: its channels keep their proportions, but where one of them would exceed 1 all move
/// towards grey, as far as it takes, so that the luminance is what the curve says.
/// @param from  luminance of the colour, > 0
/// @param to    in [0, 1]
vec3 at_luminance(vec3 colour, float from, float to) {
    vec3 scaled = colour * (to / from);
    float most = max(scaled.r, max(scaled.g, scaled.b));
    float grey = most > 1.0 ? (most - 1.0) / (most - to) : 0.0;
    return mix(scaled, vec3(to), grey);
}
