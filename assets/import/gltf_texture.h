#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.textures` and `scene.images` with what the materials use and points their slots there. A
/// texture that serves as colour and as data appears twice. Pictures are decoded on all threads; one that
/// cannot be becomes the placeholder, with one warning. @throws Error  for references to samplers or images
/// that do not exist
void import_textures(const Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
