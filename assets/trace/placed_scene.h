#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "assets/trace/ray.h"
#include "assets/trace/scene.h"

namespace rambla::assets {

/// A search in single precision is not to be trusted nearer to a ray's origin than this times the numbers
/// that it computes with: 8 roundings of 2⁻²⁴, times the 256 of k_largest_condition (embree_scene.h).
inline constexpr double k_near_share = 0x1p-13;

/// Where a line meets the plane of a triangle.
struct PlaneMeeting {
    double t = 0.0;
    double u = 0.0;  ///< share of the second corner; in a triangle: u ≥ 0, v ≥ 0, u + v ≤ 1
    double v = 0.0;  ///< share of the third corner
    bool front = false;
};

/// A triangle in the world. Its corners are the same to the bit in all triangles that share them.
struct PlacedTriangle {
    std::array<glm::dvec3, 3> corners{};
    glm::dvec3 normal{0.0};  ///< not unit length; towards who sees the front

    /// @return  nothing where line and plane are parallel, or where the triangle has no area
    [[nodiscard]] std::optional<PlaneMeeting> meet(glm::dvec3 origin_m, glm::dvec3 direction) const;
};

/// A TraceScene in double precision: everything about a hit but the search for it.
class PlacedScene {
public:
    /// @throws std::invalid_argument  naming the mesh, material or instance that refers to what is not there
    explicit PlacedScene(TraceScene scene);

    [[nodiscard]] const TraceScene& scene() const { return scene_; }
    /// Whether the instance's map is finite, so that there is something to hit.
    [[nodiscard]] bool exists(std::uint32_t instance) const { return places_[instance].exists; }
    /// ‖A‖·‖A⁻¹‖ (Frobenius) of the linear part A of an instance's map, ≥ 3; infinite if it is singular.
    [[nodiscard]] double condition(std::uint32_t instance) const { return places_[instance].condition; }
    /// No vertex of an instance is farther from where its local origin is; m.
    [[nodiscard]] double reach_m(std::uint32_t instance) const { return places_[instance].reach_m; }

    [[nodiscard]] glm::dvec3 placed(std::uint32_t instance, glm::dvec3 local) const;
    [[nodiscard]] PlacedTriangle placed_triangle(std::uint32_t instance, std::uint32_t triangle) const;

    /// What a ray meets at a triangle that a search in single precision has proposed: nothing if the triangle
    /// is not there for this ray, lies outside of its ends, shows it a face that is culled, or is cut out by
    /// a mask. Where the line passes the triangle by a rounding error of single precision, its nearest point
    /// is met, so that nothing gets through between two triangles – but not next to the ray's origin, where
    /// that would let the edge of a neighbour stop rays that leave a surface.
    [[nodiscard]] std::optional<PlaneMeeting> meet(const TraceRay& ray, const RaySpread* spread,
                                                   std::uint32_t instance, std::uint32_t triangle) const;

    [[nodiscard]] TraceHit hit(const TraceRay& ray, std::uint32_t instance, std::uint32_t triangle,
                               const PlaneMeeting& meeting) const;

private:
    struct Place {
        glm::dmat3 linear{1.0};
        glm::dmat3 normal_from_local{1.0};  ///< sign(det) · cofactor matrix
        glm::dvec3 translation_m{0.0};
        double condition = 0.0;
        double reach_m = 0.0;
        bool exists = false;
        bool clockwise = false;  ///< in the world, from the front
    };
    [[nodiscard]] static Place place_of(const TraceInstance& instance, double mesh_reach);
    [[nodiscard]] std::array<std::uint32_t, 3> corners_of(std::uint32_t mesh, std::uint32_t triangle) const;
    [[nodiscard]] bool is_cut_out(const TraceMaterial& material, const TraceMesh& mesh,
                                  std::array<std::uint32_t, 3> corners, const PlaneMeeting& meeting,
                                  double texels_per_pixel) const;
    [[nodiscard]] double footprint(const TraceMaterial& material, const TraceMesh& mesh,
                                   std::array<std::uint32_t, 3> corners, const PlacedTriangle& placed,
                                   const TraceRay& ray, const RaySpread& spread) const;
    [[nodiscard]] glm::dvec3 shading_normal(const TraceMesh& mesh, std::array<std::uint32_t, 3> corners,
                                            const Place& place, const PlaneMeeting& meeting,
                                            glm::dvec3 geometric) const;

    TraceScene scene_;
    std::vector<Place> places_;
};

}  // namespace rambla::assets
