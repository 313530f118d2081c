#pragma once

#include <array>
#include <string_view>

#include "assets/parameter.h"
#include "assets/process/occluders.h"
#include "assets/process/simplify.h"
#include "assets/process/texture.h"
#include "assets/processed.h"
#include "assets/scene.h"

namespace rambla::assets {

enum class BorderLock : std::uint8_t { never, between_parts, always };
inline constexpr std::array<std::string_view, 3> k_border_locks{"never", "between-parts", "always"};

struct MeshParameters {
    BorderLock lock_borders = BorderLock::between_parts;
    float overdraw = 1.05f;  ///< how much worse the vertex cache may do for less overdraw
};
inline constexpr std::array k_mesh_parameters{
    parameter<&MeshParameters::lock_borders>("lock-borders", k_border_locks,
                                             "Which meshes keep their borders in all levels of detail."),
    parameter<&MeshParameters::overdraw>("overdraw", "", 1, 3,
                                         "Vertex cache misses allowed for less overdraw, times the fewest."),
};

/// Each with its table.
struct ProcessParameters {
    MeshParameters meshes{};
    LodParameters lods{};
    OccluderParameters occluders{};
    TextureParameters textures{};
};

/// What only the scene knows of a mesh.
struct MeshUse {
    bool meets_others = false;  ///< it is one of several parts of a model
    bool see_through = false;   ///< some material of it is not opaque
};

[[nodiscard]] std::vector<MeshUse> mesh_uses(const Scene& scene);

/// Identical vertices merged, levels of detail, good orders, shadow mesh, bounds, occluder. The result
/// depends on the arguments alone, so that it can be kept under their hash.
[[nodiscard]] ProcessedMesh process_mesh(const Mesh& mesh, MeshUse use, const ProcessParameters& parameters);

/// Processes each mesh, and each use of each picture, once, side by side on oneTBB. The result is the same
/// for any number of threads.
/// @param scene  as importers and generators make it: valid indices, finite positions
[[nodiscard]] ProcessedScene process(const Scene& scene, const ProcessParameters& parameters);

}  // namespace rambla::assets
