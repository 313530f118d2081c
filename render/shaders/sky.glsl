#include "constants.glsl"

/// The surroundings as three radiances: a sky that runs from horizon to zenith as the square root of the
/// direction's height, over a ground of even brightness. Simple enough to integrate by hand, so that what is
/// seen, what is mirrored and what lights walls is one and the same sky.
struct Surroundings {
    vec3 zenith;
    vec3 horizon;
    vec3 ground;
    float visibility;  ///< share of the sky's light that reaches surfaces; the rest is ground
};

/// Radiance from a direction above the horizon. @param height  y of the unit direction
vec3 upper_sky(Surroundings s, float height) {
    return mix(s.horizon, s.zenith, sqrt(clamp(height, 0.0, 1.0)));
}

/// What the eye sees, the sun's disc excepted. The ground far away fades into the horizon's haze.
const float k_haze_height = 0.06;
const float k_far_ground_share = 0.75;

vec3 sky_radiance(Surroundings s, vec3 direction) {
    float depth_below = clamp(-direction.y / k_haze_height, 0.0, 1.0);
    float below = depth_below * depth_below * (3.0 - 2.0 * depth_below);
    return mix(upper_sky(s, direction.y), mix(s.horizon, s.ground, k_far_ground_share), below);
}

/// Irradiance over π on a surface with this normal: its diffuse ambient light per unit of albedo.
///
/// Half of what a wall sees is sky, in general (1 + n.y)/2. Of √height, the cosine-weighted mean over the
/// visible part of the sky is ∫√y·2y dy = 0.8 facing up, and (4/π)·∫√y·√(1 − y²) dy = 0.610 facing sideways;
/// between and below, a line.
vec3 diffuse_ambient(Surroundings s, vec3 normal) {
    const float facing_up = 0.8, facing_sideways = 0.610;
    float mean_root = mix(facing_sideways, facing_up, clamp(normal.y, -1.0, 1.0));
    float sky_share = s.visibility * (0.5 + 0.5 * clamp(normal.y, -1.0, 1.0));
    return mix(s.ground, mix(s.horizon, s.zenith, mean_root), sky_share);
}

/// Radiance around the mirrored direction, blurred as wide as the roughness asks for: the step at the horizon
/// becomes a ramp of half width α, and the sky's gradient tends to its mean, as the lobe covers more of it.
/// In a place of houses, directions just below the horizon end on façades and street: ground. So does what houses hide
/// of the sky, as far as the lobe is wide.
vec3 specular_ambient(Surroundings s, vec3 reflected_direction, float roughness) {
    const float mean_root_of_sky = 2.0 / 3.0;
    float alpha = roughness * roughness;
    float half_width = max(alpha, 0.01);
    float height = reflected_direction.y;
    float sky_share = smoothstep(-half_width, half_width, height) * mix(1.0, s.visibility, alpha);
    float root = mix(sqrt(clamp(height, 0.0, 1.0)), mean_root_of_sky, alpha);
    return mix(s.ground, mix(s.horizon, s.zenith, root), sky_share);
}

/// Specular light that reaches a point of this ambient occlusion.
/// Lagarde and de Rousiers 2014, "Moving Frostbite to physically based rendering", listing 26.
float specular_occlusion(float occlusion, float n_dot_v, float roughness) {
    return clamp(pow(n_dot_v + occlusion, exp2(-16.0 * roughness - 1.0)) - 1.0 + occlusion, 0.0, 1.0);
}
