#pragma once

#include <filesystem>

#include "assets/scene.h"

namespace rambla::assets {

/// Writes a scene as glTF 2.0: one .glb with its pictures inside as PNG. What glTF itself cannot say becomes
/// KHR_lights_punctual, KHR_materials_emissive_strength, _ior, _specular, _transmission and _unlit,
/// KHR_texture_transform and MSFT_lod, none of them required, or extras: heights, light maps, haze and its
/// emitters, and the time of day. The roots form the default scene; prototypes that no root reaches form a
/// second one, coarser levels of detail none. import_gltf gives back an equal scene, but for what glTF does
/// not have: meshes without indices, skeletons without joints, clips without channels and morph targets that
/// move nothing.
/// @throws Error  when the file cannot be written, is not called .glb, or the scene holds float images
void export_gltf(const std::filesystem::path& file, const Scene& scene);

}  // namespace rambla::assets
