// Light of the Environment on a surface; shared by the deferred and the blend pass.
#include "frame.glsl"
#include "brdf.glsl"
#include "sky.glsl"

Surroundings frame_surroundings() {
    return Surroundings(frame.sky_zenith_radiance.rgb, frame.sky_horizon_radiance.rgb,
                        frame.ground_radiance.rgb, frame.ground_radiance.a);
}

vec3 sky_light(Surface s, vec3 to_eye) {
    Surroundings surroundings = frame_surroundings();
    float n_dot_v = clamp(dot(s.normal, to_eye), k_min_n_dot_v, 1.0);
    vec3 reflectance = environment_reflectance(s.f0, s.f90, s.roughness, n_dot_v);
    vec3 diffuse = (1.0 - reflectance) * s.diffuse * diffuse_ambient(surroundings, s.normal) * s.occlusion;
    vec3 mirrored = reflect(-to_eye, s.normal);
    vec3 specular = reflectance * specular_ambient(surroundings, mirrored, s.roughness) *
                    specular_occlusion(s.occlusion, n_dot_v, s.roughness);
    return diffuse + specular;
}

/// @param lit  share of the sun that reaches the surface
vec3 sun_light(Surface s, vec3 to_eye, float lit) {
    return lit * frame.sun_illuminance.rgb * reflected(s, to_eye, frame.direction_to_sun.xyz);
}
