#pragma once

#include <array>

#include "assets/mesh.h"
#include "assets/parameter.h"
#include "assets/processed.h"

namespace rambla::assets {

struct OccluderParameters {
    int voxels = 32;         ///< along the longest axis, to find boxes with
    int boxes = 4;           ///< at most
    float smallest = 0.05f;  ///< new volume that a box must add, as a share of the enclosed one
    float least_size_m = 2;  ///< longest extent below which a mesh is not worth an occluder
};
inline constexpr std::array k_occluder_parameters{
    parameter<&OccluderParameters::voxels>("voxels", "", 4, 64, "Voxels along a mesh's longest axis."),
    parameter<&OccluderParameters::boxes>("boxes", "", 0, 16, "Most boxes of a mesh."),
    parameter<&OccluderParameters::smallest>("smallest", "", 0.001, 1,
                                             "New volume that a box must add, of the enclosed one."),
    parameter<&OccluderParameters::least_size_m>("least-size", "m", 0, 100,
                                                 "Extent below which a mesh gets no occluder."),
};

/// Boxes from the voxelised interior: the largest one first, then the largest of what is left, each extended
/// over its neighbours and finally beyond voxels to where it would touch the mesh.
/// @param mesh  any; only closed meshes of triangles that face outwards have an inside
[[nodiscard]] OccluderProxy occluder_proxy(const Mesh& mesh, const OccluderParameters& parameters);

}  // namespace rambla::assets
