// Sky, sun and haze, drawn where nothing else is.
#include "sun_and_sky.glsl"
#include "unproject.glsl"
#include "colour.glsl"

in vec2 uv;
layout(location = 0) out vec4 out_radiance;

/// Angular radius of the sun, widened a little by its aureole: 0.2665° is the disc, the rim fades over as
/// much again.
const float k_cos_disc = 0.99998918;
const float k_cos_rim = 0.99995673;
/// The disc's true radiance, E/(π·sin² 0.2665°), is 15 000 times that of a white wall; shown is enough to be
/// white under any curve at usual exposures, and little enough not to swamp a half float.
const float k_disc_radiance_per_illuminance = 40.0;
/// Light scattered forwards around the sun, as a share of its illuminance.
const float k_glow_per_illuminance = 0.06;
const float k_glow_exponent = 90.0;

void main() {
    vec3 direction = mat3(frame.world_from_view) * view_ray(uv, frame.unprojection, frame.depth_scale);
    float cos_sun = dot(direction, frame.direction_to_sun.xyz);
    float above_horizon = smoothstep(-0.01, 0.01, direction.y);
    float disc = k_disc_radiance_per_illuminance * smoothstep(k_cos_rim, k_cos_disc, cos_sun);
    float glow = k_glow_per_illuminance * pow(max(cos_sun, 0.0), k_glow_exponent);
    vec3 radiance = sky_radiance(frame_surroundings(), direction) +
                    frame.sun_illuminance.rgb * ((disc + glow) * above_horizon);
    out_radiance = vec4(storable_radiance(radiance * frame.exposure.x), 1.0);
}
