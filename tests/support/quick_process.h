#pragma once

#include <memory>

#include "assets/process/process.h"

namespace rambla::tests {

/// What drawing needs of a small scene that a test has made by hand: without levels of detail, occluders and
/// block compression, which take time.
[[nodiscard]] inline std::shared_ptr<const assets::ProcessedScene> quick_process(const assets::Scene& scene) {
    assets::ProcessParameters parameters;
    parameters.lods.levels = 0;
    parameters.occluders.boxes = 0;
    parameters.textures.compression = assets::Compression::off;
    return std::make_shared<const assets::ProcessedScene>(assets::process(scene, parameters));
}

}  // namespace rambla::tests
