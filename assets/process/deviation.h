#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "assets/mesh.h"
#include "assets/process/surface.h"

namespace rambla::assets {

/// Largest distance from any point of one surface to another one: the true value lies between the two.
struct Deviation {
    double at_least_m = 0.0;
    double at_most_m = 0.0;
};

/// One-sided Hausdorff distance from the triangles of `from` to `to`, within bounds: the distance to one
/// convex thing is convex, so that over a triangle its largest value is at a corner. Triangles whose bound
/// lies above what has been found at corners are split until it does not (Guthe et al. 2005, "Fast and
/// accurate Hausdorff distance calculation between meshes"), where they pass from one nearest triangle to
/// another if they do.
/// @param tolerance_m  refinement ends when the bounds differ by no more, or by no more than 2 %
/// @return             both 0 for an empty `from`, both infinite for an empty `to`
[[nodiscard]] Deviation one_sided_deviation(const Surface& from, const Surface& to, double tolerance_m);

/// Likewise, to solid boxes.
[[nodiscard]] Deviation one_sided_deviation(const Surface& from, std::span<const Bounds> to,
                                            double tolerance_m);

/// The greater one of both directions (Hausdorff distance).
[[nodiscard]] Deviation deviation(const Surface& a, const Surface& b, double tolerance_m);

/// How far shading attributes of a coarser surface are off, root mean square over the mesh's area.
struct AttributeDeviation {
    double normal_deg = 0.0;  ///< between interpolated normals; 0 without normals
    double uv = 0.0;          ///< between first texture coordinates; 0 without them
};

/// Compares points spread over the mesh with the nearest points of `coarse`, whose indices refer to the
/// mesh's own vertices.
[[nodiscard]] AttributeDeviation attribute_deviation(const Mesh& mesh, const Surface& coarse);

}  // namespace rambla::assets
