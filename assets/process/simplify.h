#pragma once

#include <array>

#include "assets/lod.h"
#include "assets/mesh.h"
#include "assets/parameter.h"

namespace rambla::assets {

struct LodParameters {
    int levels = 6;            ///< at most, besides the mesh itself
    float ratio = 0.5f;        ///< triangles that a level wants, of those of the level before
    float pays = 0.8f;         ///< a level with more than this share of the level before is not worth having
    float max_error = 0.1f;    ///< of a level, as a share of the mesh's largest extent
    float sloppy_below_m = 3;  ///< largest extent of meshes that may lose seams and gain holes; 0: none may
};
inline constexpr std::array k_lod_parameters{
    parameter<&LodParameters::levels>("levels", "", 0, 16, "Most levels of detail besides the mesh itself."),
    parameter<&LodParameters::ratio>("ratio", "", 0.1, 0.9,
                                     "Triangles that a level wants, of those of the level before."),
    parameter<&LodParameters::pays>("pays", "", 0.1, 0.99,
                                    "Largest share of the level before's triangles that is worth a level."),
    parameter<&LodParameters::max_error>("max-error", "", 0, 1,
                                         "Largest error of a level, of the mesh's largest extent."),
    parameter<&LodParameters::sloppy_below_m>("sloppy-below", "m", 0, 100,
                                              "Extent below which a mesh may lose seams and gain holes."),
};

enum class Borders : std::uint8_t {
    free,   ///< edges with a triangle on one side only may move, within the error
    locked  ///< their vertices stay: other pieces meet them
};

/// Coarser levels of a triangle mesh by edge collapse (Garland & Heckbert 1997, as meshoptimizer has it),
/// each made from the mesh itself. Vertices stay where they are, so that skinning goes on working, and
/// texture and normal seams are collapsed only along themselves. Errors are not the collapses' own estimates
/// but measured afterwards (assets/process/deviation.h): upper bounds of the Hausdorff distance. The chain
/// ends where a level would not pay or would exceed the error. Where edge collapse ends and the mesh is
/// small, neither skinned nor morphed, and has free borders, vertices are merged in grid cells instead
/// (`sloppy`).
/// @param mesh  triangles without identical vertices (merge_identical_vertices), finite; all other meshes,
/// and
///              those that nothing can be taken from, have no levels
[[nodiscard]] LodChain lod_chain(const Mesh& mesh, const LodParameters& parameters, Borders borders);

}  // namespace rambla::assets
