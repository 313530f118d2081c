#pragma once

#include <filesystem>

#include "assets/scene.h"

namespace rambla::assets {

/// Writes a scene as glTF 2.0: one .glb with its pictures inside as PNG, lights as KHR_lights_punctual.
/// The roots form the default scene; prototypes that no root reaches form a second one.
/// @throws Error  when the file cannot be written, is not called .glb, or the scene holds float images
void export_gltf(const std::filesystem::path& file, const Scene& scene);

}  // namespace rambla::assets
