#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

#include "assets/trace/scene.h"

namespace rambla::assets {

/// Which faces of single-sided surfaces a ray passes through; double-sided ones stop it always.
enum class TraceFaces : std::uint8_t {
    seen,  ///< back faces, as a rasteriser culls them: rays of an eye
    lit,   ///< front faces: of rays towards a light whose shadow map culls back faces, as the light sees them
    all    ///< none
};

/// origin + t · direction for t between its ends, which do not belong to it.
struct TraceRay {
    glm::dvec3 origin_m{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< of any length but 0
    double t_min = 0.0;                    ///< units of `direction`
    double t_max = std::numeric_limits<double>::infinity();
    TraceFaces faces = TraceFaces::seen;
    std::uint32_t rays = k_rays_of_all;  ///< meets instances that have one of these bits
};

/// How a ray's neighbours in a picture differ from it: chooses the mip level of masks. Of the neighbour to
/// the right, and of the one below.
struct RaySpread {
    glm::dvec3 origin_right_m{0.0};
    glm::dvec3 origin_below_m{0.0};
    glm::dvec3 direction_right{0.0};
    glm::dvec3 direction_below{0.0};
};

/// What a ray met. Numbers are exact to double precision for the triangle that was hit.
struct TraceHit {
    std::uint32_t object = k_none;
    std::uint32_t instance = k_none;  ///< of TraceScene::instances; k_none: nothing was hit
    std::uint32_t triangle = k_none;  ///< of its mesh
    bool front = false;               ///< which side was hit
    glm::dvec2 barycentric{0.0};      ///< shares of the second and the third corner
    double t = 0.0;                   ///< units of the ray's direction
    double distance_m = 0.0;
    glm::dvec3 position_m{0.0};
    glm::dvec3 geometric_normal{0.0};  ///< unit length, on the side that was hit
    /// Interpolated, unit length, of the surface's side that was hit; geometric where the mesh has none.
    glm::dvec3 shading_normal{0.0};
    glm::dvec2 uv0{0.0};
    glm::dvec2 uv1{0.0};
    double offset_m = 0.0;  ///< see offset_origin()

    [[nodiscard]] bool exists() const { return instance != k_none; }
};

/// Where rays begin that leave a hit on the side that was hit, so that neither the triangle nor its coplanar
/// neighbours stop them.
///
/// Let m be the largest coordinate that placing the triangle's corners sums up, |A|·|v| + |b| for v ↦ A·v +
/// b. In double precision corners are wrong by less than 4·2⁻⁵³·m, and the plane through them lies within
/// 2⁻⁵⁰·m·a of the hit, where a = (product of two sides)/(twice the area) is about the triangle's aspect
/// ratio. The offset of 2⁻³²·m exceeds that for a < 2¹⁸. It is 23 nm at 100 m and 0.2 mm at 1000 km.
[[nodiscard]] inline glm::dvec3 offset_origin(const TraceHit& hit) {
    return hit.position_m + hit.offset_m * hit.geometric_normal;
}

}  // namespace rambla::assets
