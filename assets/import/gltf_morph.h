#pragma once

#include <tiny_gltf.h>

#include "assets/import/gltf_vertices.h"
#include "assets/mesh.h"

namespace rambla::assets::gltf {

/// Fills `morphs` of a mesh whose own columns are there. Targets for attributes that the mesh has not are
/// left out with a warning. @throws Error
void read_morphs(VertexReader& reader, const tinygltf::Primitive& primitive, Mesh& mesh);

/// How many morph targets the primitives of a mesh have. @throws Error  where they differ
[[nodiscard]] std::size_t morph_count(const Document& document, const tinygltf::Mesh& mesh,
                                      const std::string& element);

/// Names of morph targets, which exporters write to `extras.targetNames`; empty where there is none.
[[nodiscard]] std::string morph_name(const tinygltf::Mesh& mesh, std::size_t target);

/// Weights for so many morph targets: what the document gives, then zeros. A wrong number is a warning.
[[nodiscard]] std::vector<float> morph_weights(const Document& document, const std::vector<double>& given,
                                               std::size_t targets, const std::string& element);

}  // namespace rambla::assets::gltf
