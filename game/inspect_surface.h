#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "assets/import/gltf_facts.h"
#include "assets/scene.h"

namespace rambla::game {

/// What `rambla inspect` tells of one material, texture or image.
[[nodiscard]] nlohmann::json inspected_material(const assets::Material& material,
                                                const std::vector<std::string>& extensions);
[[nodiscard]] nlohmann::json inspected_texture(const assets::Texture& texture);
[[nodiscard]] nlohmann::json inspected_image(const assets::Scene& scene, std::size_t index,
                                             const assets::ImageFacts& facts);

[[nodiscard]] const char* inspected_format(const assets::Image& image);  ///< of its texels in memory
[[nodiscard]] nlohmann::json index_or_null(std::uint32_t index);         ///< k_none is null
[[nodiscard]] nlohmann::json numbers(glm::vec3 v);

}  // namespace rambla::game
