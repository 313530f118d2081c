#pragma once

#include <glm/glm.hpp>

namespace rambla::assets {

/// A lit point in doubles, as glTF 2.0, appendix B, has it: a dielectric of index 1.5 where it is no metal.
struct ReflectingPoint {
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit length
    glm::dvec3 base_colour{1.0};       ///< linear
    double roughness = 1.0;            ///< perceptual; below 0.045 it counts as that
    double metalness = 0.0;            ///< [0, 1]
};

/// Reflected radiance per unit of illuminance on a plane across the light: BRDF · cos θ; 0 for light from
/// behind. GGX with height-correlated Smith masking (Walter et al. 2007, eq. 33; Heitz 2014, eqs. 72 and 99),
/// Schlick's Fresnel term and a Lambert base. Written from the publications, so that shaders can be held
/// against it.
/// @param v, l  unit vectors from the point to the eye and to the light
[[nodiscard]] glm::dvec3 reflected_ggx(const ReflectingPoint& point, glm::dvec3 v, glm::dvec3 l);

/// The same with a Blinn–Phong lobe of the exponent 2/α² − 2, normalised by (n + 8)/(8π), without masking.
[[nodiscard]] glm::dvec3 reflected_blinn(const ReflectingPoint& point, glm::dvec3 v, glm::dvec3 l);

/// All that is reflected scattered evenly.
[[nodiscard]] glm::dvec3 reflected_lambert(const ReflectingPoint& point, glm::dvec3 v, glm::dvec3 l);

/// Share of a lamp's illuminance · m² that arrives at a distance: 1/d² in the window max(0, 1 − (d/r)⁴)².
/// Karis 2013, "Real shading in Unreal Engine 4", eq. 9; d is 1 cm at least.
[[nodiscard]] double lamp_attenuation(double distance_m, double radius_m);

}  // namespace rambla::assets
