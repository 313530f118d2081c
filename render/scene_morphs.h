#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assets/processed.h"
#include "render/scene_store.h"

namespace rambla::render {

/// The morph targets of all meshes, as the storage block BINDING_MORPHS holds them: a shared::MorphTarget for
/// each, in the order of the meshes, then the words of their columns. Empty if there are none.
/// @param ranges  of the meshes
[[nodiscard]] std::vector<std::uint32_t> pack_morphs(std::span<const assets::ProcessedMesh> meshes,
                                                     std::span<const MeshRange> ranges);

}  // namespace rambla::render
