// Define BRDF: one of the grades below; without it, GGX.
#include "constants.glsl"

#define BRDF_GGX 0
#define BRDF_BLINN 1
#define BRDF_LAMBERT 2
#ifndef BRDF
#define BRDF BRDF_GGX
#endif

/// What a lit point is made of: the metallic-roughness model of glTF 2.0, appendix B.
struct Surface {
    vec3 normal;        ///< unit length
    vec3 diffuse;       ///< Lambert albedo: base colour of dielectrics, black for metals
    vec3 f0;            ///< specular reflectance at normal incidence
    float f90;          ///< the same at grazing incidence
    float roughness;    ///< perceptual, [k_min_roughness, 1]
    float occlusion;    ///< share of the surroundings that is visible, [0, 1]
};

/// Reflectance of glass, plastic, stone: index of refraction 1.5.
const float k_dielectric_f0 = 0.04;
/// A mirror's highlight of a point-like sun would be infinitely small and bright; this one's distribution peaks at
/// 1/(π·α²) = 7.8e4. Seen head-on that fits a half float; at grazing angles storable_radiance() saturates it.
const float k_min_roughness = 0.045;

/// Below this reflectance (index of refraction 1.33), a dielectric has none at grazing incidence either, by degrees: no
/// real one reflects less, so that what does has been given a weaker reflection on purpose.
const float k_least_f0 = 0.02;

/// @param dielectric_f0  specular reflectance at normal incidence where it is no metal
Surface make_surface(vec3 normal, vec3 base_colour, float roughness, float metalness, float occlusion,
                     float dielectric_f0) {
    vec3 f0 = mix(vec3(dielectric_f0), base_colour, metalness);
    float f90 = mix(min(dielectric_f0 / k_least_f0, 1.0), 1.0, metalness);
    return Surface(normal, base_colour * (1.0 - metalness), f0, f90, clamp(roughness, k_min_roughness, 1.0), occlusion);
}

Surface make_surface(vec3 normal, vec3 base_colour, float roughness, float metalness, float occlusion) {
    return make_surface(normal, base_colour, roughness, metalness, occlusion, k_dielectric_f0);
}

/// GGX distribution, α²/(π·((N·H)²(α² − 1) + 1)²). The bracket loses all digits for N·H → 1 and small α, so
/// it is computed as α²(N·H)² + |N×H|², the same by Lagrange's identity, and never 0 for unit vectors.
float distribution_ggx(vec3 n, vec3 h, float alpha) {
    vec3 n_cross_h = cross(n, h);
    float n_dot_h = dot(n, h);
    float bracket = alpha * alpha * n_dot_h * n_dot_h + dot(n_cross_h, n_cross_h);
    float ratio = alpha / bracket;
    return ratio * ratio / k_pi;
}

/// Height-correlated Smith masking-shadowing over 4·(N·L)·(N·V). Heitz 2014, eq. 99.
/// Cosines in [0, 1], not both 0: callers keep n_dot_v > 0.
float visibility_smith_ggx(float n_dot_l, float n_dot_v, float alpha) {
    float a2 = alpha * alpha;
    float masking = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - a2) + a2);
    float shadowing = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - a2) + a2);
    return 0.5 / (masking + shadowing);
}

/// Schlick 1994, eq. 15.
vec3 fresnel_schlick(vec3 f0, float f90, float v_dot_h) {
    float m = clamp(1.0 - v_dot_h, 0.0, 1.0);
    float m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}

/// Views from behind a mapped or interpolated normal are treated as grazing ones.
const float k_min_n_dot_v = 1e-4;

/// With L = −V there is no half vector; F is then at grazing and D is 0, which the fallback H = N states
/// without a division by 0.
vec3 half_vector(vec3 normal, vec3 v, vec3 l) {
    vec3 sum = v + l;
    float length2 = dot(sum, sum);
    return length2 > 1e-12 ? sum * inversesqrt(length2) : normal;
}

/// Diffuse and specular part for n_dot_l > 0: glTF's dielectric and metal.
vec3 reflected_ggx(Surface s, vec3 v, vec3 l, float n_dot_l) {
    float n_dot_v = max(dot(s.normal, v), k_min_n_dot_v);
    vec3 h = half_vector(s.normal, v, l);
    float alpha = s.roughness * s.roughness;
    vec3 fresnel = fresnel_schlick(s.f0, s.f90, dot(v, h));
    float specular = distribution_ggx(s.normal, h, alpha) * visibility_smith_ggx(n_dot_l, n_dot_v, alpha);
    return ((1.0 - fresnel) * s.diffuse / k_pi + fresnel * specular) * n_dot_l;
}

/// The same with a Blinn–Phong lobe of the exponent n = 2/α² − 2 that falls off like GGX near its middle
/// (Walter et al. 2007, section 5.2), normalised by (n + 8)/(8π) (Akenine-Möller et al. 2008, eq. 7.48), and
/// without masking and shadowing. (N·H)ⁿ is exp2(n·log2(N·H)); N·H = 0 gives 0, for n = 0 too, where the lobe is flat
/// but for that point.
vec3 reflected_blinn(Surface s, vec3 v, vec3 l, float n_dot_l) {
    vec3 h = half_vector(s.normal, v, l);
    float alpha = s.roughness * s.roughness;
    float n = 2.0 / (alpha * alpha) - 2.0;
    float n_dot_h = clamp(dot(s.normal, h), 0.0, 1.0);
    float lobe = n_dot_h > 0.0 ? exp2(n * log2(n_dot_h)) : 0.0;
    vec3 fresnel = fresnel_schlick(s.f0, s.f90, dot(v, h));
    return ((1.0 - fresnel) * s.diffuse / k_pi + fresnel * ((n + 8.0) / (8.0 * k_pi) * lobe)) * n_dot_l;
}

/// Everything scattered evenly; what a metal would mirror, too, so that it is not black.
vec3 reflected_lambert(Surface s, float n_dot_l) {
    return (s.diffuse + s.f0) / k_pi * n_dot_l;
}

/// Reflected radiance per unit of illuminance on a plane across the light: BRDF · cos θ. 0 for light from
/// behind.
/// @param v, l  unit vectors from the surface to the eye and to the light
vec3 reflected(Surface s, vec3 v, vec3 l) {
    float n_dot_l = dot(s.normal, l);
    if (n_dot_l <= 0.0) return vec3(0.0);
#if BRDF == BRDF_GGX
    return reflected_ggx(s, v, l, n_dot_l);
#elif BRDF == BRDF_BLINN
    return reflected_blinn(s, v, l, n_dot_l);
#else
    return reflected_lambert(s, n_dot_l);
#endif
}

/// Share of evenly distributed surrounding light that the specular lobe reflects: scale of f0 and bias.
/// Karis 2014, "Physically based shading on mobile": fit of the split-sum integral for GGX.
vec3 environment_reflectance(vec3 f0, float f90, float roughness, float n_dot_v) {
    const vec4 c0 = vec4(-1.0, -0.0275, -0.572, 0.022);
    const vec4 c1 = vec4(1.0, 0.0425, 1.04, -0.04);
    vec4 r = roughness * c0 + c1;
    float a004 = min(r.x * r.x, exp2(-9.28 * n_dot_v)) * r.x + r.y;
    vec2 scale_bias = vec2(-1.04, 1.04) * a004 + r.zw;
    return clamp(f0 * scale_bias.x + f90 * scale_bias.y, 0.0, 1.0);
}
