#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "assets/scene.h"

namespace rambla::assets {

/// The members `materials`, `textures` and `samplers` of a glTF document, those that are not empty.
/// @param extensions  gets the names of the extensions that they use
[[nodiscard]] nlohmann::json materials_json(const Scene& scene, std::set<std::string>& extensions);

/// 1, or the least power of two that is not below any component: factors of glTF end at 1, and what a power
/// of two takes off comes back bit by bit.
[[nodiscard]] float power_of_two_above(glm::vec3 v);

}  // namespace rambla::assets
