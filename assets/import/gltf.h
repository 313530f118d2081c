#pragma once

#include <cstdint>
#include <filesystem>

#include "assets/scene.h"

namespace rambla::assets {

/// Limits on untrusted files; generous for real ones. Beyond them, a file yields at most 8 vertices or
/// indices per byte of itself and its buffers (or a million), so that small files cannot fill the memory.
struct ImportLimits {
    std::uint64_t file_bytes = 4ull << 30;  ///< the document and its buffers together
    std::uint64_t json_bytes = 1ull << 30;
    std::uint64_t json_values = 20'000'000;
    std::uint64_t vertices = 200'000'000;  ///< vertices and indices of all meshes
    std::uint32_t image_size_px = 16'384;  ///< width and height
};

/// Reads a glTF 2.0 file (.gltf with its buffers and images, or .glb) into plain data.
/// - The roots are those of the default scene (the first, if none is named; nodes without a parent, if there
/// is no
///   scene). Skinned meshes and morph targets come in their rest pose, without animations.
/// - Missing normals are computed flat; tangents only where the material has a normal texture.
/// - A missing or broken image becomes a visible placeholder with one warning that names it.
/// - KHR_lights_punctual: lux and candela become Light::intensity by their number, unscaled.
/// - KHR_materials_transmission is shown as blending with alpha 1 − 0.9 · transmission, so that some of the
/// surface
///   remains to carry its highlights.
/// - Buffers that have no data anywhere read as zeros.
/// Files are not trusted: URIs may not leave the document's folder, every offset is checked.
/// @throws Error  naming file, element, what was found and what was expected; also for required extensions
/// that are
///                not supported (optional ones are ignored with one warning each)
[[nodiscard]] Scene import_gltf(const std::filesystem::path& file, const ImportLimits& limits = {});

}  // namespace rambla::assets
