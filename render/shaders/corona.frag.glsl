// Rays and a halo about a lamp, added to the picture.
#include "corona.glsl"

in vec2 place_deg;
flat in vec3 illuminance;
flat in float lamp_deg;

layout(location = 0) out vec4 out_light;

void main() {
    float angle_deg = length(place_deg);
    float turn = atan(place_deg.y, place_deg.x) / (2.0 * k_pi);
    // Needles part with the distance from the lamp; in its middle they are one.
    float apart = smoothstep(0.0, 2.0 * lamp_deg, angle_deg);
    float needles = corona_needles(angle_deg, lamp_deg) * mix(1.0, corona_rays(turn), apart);
    float rim = 1.0 - smoothstep(0.6 * k_corona_deg, k_corona_deg, angle_deg);
    vec3 light = illuminance * rim * (needles + corona_halo(angle_deg));
    out_light = vec4(min(light, vec3(k_max_radiance)), 0.0);
}
