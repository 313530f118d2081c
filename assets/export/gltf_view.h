#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "assets/scene.h"

namespace rambla::assets {

/// The members `cameras` and `extensions` (KHR_lights_punctual) of a glTF document, those that are not empty.
/// @param extensions  gets the names of the extensions that they use
[[nodiscard]] nlohmann::json views_json(const Scene& scene, std::set<std::string>& extensions);

}  // namespace rambla::assets
