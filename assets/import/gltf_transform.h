#pragma once

#include <optional>

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

struct Decomposition {
    Transform transform;
    bool exact = true;  ///< false when the matrix shears: the shear is lost
};

/// Splits an affine matrix into translation · rotation · scale. A mirroring matrix gets a negative scale
/// along x.
[[nodiscard]] Decomposition decompose(const glm::mat4& matrix);

/// The rotation that x, y, z, w mean, of unit length; nothing for what is no rotation.
[[nodiscard]] std::optional<glm::quat> unit_rotation(glm::vec4 xyzw);

/// The local transform of a node, from its matrix or its parts. @throws Error
[[nodiscard]] Transform import_transform(const Document& document, const tinygltf::Node& node,
                                         const std::string& element);

}  // namespace rambla::assets::gltf
