#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "assets/image.h"
#include "assets/import/gltf_facts.h"
#include "assets/import/image.h"

namespace rambla::game {

/// All that `rambla inspect` tells of a glTF file, as rambla.inspect/1. Elements refer to each other by
/// index; null is none. Bytes of meshes and images are those in memory.
/// @param warnings  what the import had to say
[[nodiscard]] nlohmann::json inspection(const std::filesystem::path& file, const assets::GltfWithFacts& gltf,
                                        const std::vector<std::string>& warnings);

/// The same of a picture file.
[[nodiscard]] nlohmann::json inspection(const std::filesystem::path& file,
                                        const assets::ImageWithFacts& picture);

}  // namespace rambla::game
