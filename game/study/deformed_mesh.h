#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "assets/processed.h"
#include "systems/frame.h"

namespace rambla::game::study {

/// Where a mesh's vertices are after morph targets, and skins, have moved them.
struct DeformedMesh {
    std::vector<glm::vec3> positions;  ///< skinned: camera-relative world, else the mesh's own space; metres
    std::vector<glm::vec3> normals;    ///< in the same space, of any length; empty if the mesh has none
};

/// The morph targets of a scene as systems::MorphTerm counts them.
[[nodiscard]] std::vector<const assets::MorphTarget*> morph_targets(const assets::ProcessedScene& scene);

/// Moves vertices as render/shaders/deform.glsl does, with the weights that the graphics card has, in double.
/// @param targets   of the Frame's scene
/// @param pipeline  says whether the instance is morphed and skinned
[[nodiscard]] DeformedMesh deformed(const assets::Mesh& mesh, const systems::Instance& instance,
                                    systems::Pipeline pipeline, const systems::Frame& frame,
                                    std::span<const assets::MorphTarget* const> targets);

}  // namespace rambla::game::study
