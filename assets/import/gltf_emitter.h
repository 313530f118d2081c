#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.emitters` from the document's `extras.ramblaEmitters`, index for index: glTF knows no
/// particles. What is no number in its range is warned about and becomes one. After the materials.
void import_emitters(const Document& document, Scene& scene);

/// The emitter that `extras.ramblaEmitter` of a node names; k_none where there is none, or, with a warning,
/// where it cannot be used. After import_emitters().
[[nodiscard]] std::uint32_t emitter_of(const Document& document, const Scene& scene,
                                       const tinygltf::Node& node, const std::string& element);

/// Takes the particles of all nodes off the document's budget: each is made and drawn anew for every picture,
/// which takes as long as many vertices do. @throws Error  when it is used up
void spend_particles(Document& document, const Scene& scene);

}  // namespace rambla::assets::gltf
