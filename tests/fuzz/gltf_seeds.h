#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rambla::fuzz {

/// A document and the content of its buffer 0.
struct GltfSeed {
    std::string name;
    std::string json;
    std::string buffer;
};

/// The same as one GLB file.
[[nodiscard]] std::vector<unsigned char> glb_of(const GltfSeed& seed);

/// Small scenes with every feature that the importer knows, our own exporter's and written by hand.
[[nodiscard]] std::vector<GltfSeed> gltf_seeds();

}  // namespace rambla::fuzz
