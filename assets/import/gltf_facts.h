#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "assets/import/gltf.h"

namespace rambla::assets {

/// One of a document's scenes.
struct SceneFacts {
    std::string name;
    std::vector<std::uint32_t> roots;  ///< node indices as the document states them, unchecked
};

/// Where an image of the imported scene comes from.
struct ImageFacts {
    std::string source;               ///< the file's name, "buffer", "data URI", or "placeholder"
    std::string format;               ///< "png", "jpeg" …; "unknown" when the bytes say nothing
    std::uint64_t encoded_bytes = 0;  ///< 0 when they cannot be read
};

/// What a glTF document says of itself beside what import_gltf makes of it.
struct GltfFacts {
    std::string version;
    std::string generator;
    std::vector<std::string> extensions_used;      ///< sorted
    std::vector<std::string> extensions_required;  ///< sorted
    std::vector<std::string> extensions_ignored;   ///< those of the used ones that change nothing here
    std::vector<SceneFacts> scenes;
    std::uint32_t default_scene = k_none;                       ///< k_none: the document names none
    std::vector<std::vector<std::string>> material_extensions;  ///< for each of Scene::materials
    std::vector<ImageFacts> images;                             ///< for each of Scene::images
    std::uint64_t document_bytes = 0;                           ///< the .gltf or .glb file
    std::uint64_t buffer_bytes = 0;                             ///< of all buffers, wherever they lie
};

struct GltfWithFacts {
    Scene scene;
    GltfFacts facts;
};

/// The scene that import_gltf returns, and the document's own facts. @throws Error
[[nodiscard]] GltfWithFacts import_gltf_with_facts(const std::filesystem::path& file,
                                                   const ImportLimits& limits = {});

}  // namespace rambla::assets
