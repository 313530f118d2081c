#pragma once

#include <nlohmann/json.hpp>

#include "assets/scene.h"

namespace rambla::assets {

/// The list that becomes `extras.ramblaEmitters` of a document; see assets/import/gltf_emitter.h.
[[nodiscard]] nlohmann::json emitters_json(const Scene& scene);

}  // namespace rambla::assets
