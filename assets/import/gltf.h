#pragma once

#include <cstdint>
#include <filesystem>

#include "assets/scene.h"

namespace rambla::assets {

/// Limits on untrusted files; generous for real ones. Beyond them, a file yields at most 8 elements per byte
/// of itself and its buffers (or a million), so that small files cannot fill the memory. An element is a
/// vertex, an index, a vertex of a morph target, a number or time of a clip's key; an instance counts as 16.
/// Pictures have at most 4200 bytes of texels per byte of all of its files (or 256 MiB), or twice that when
/// many are small (picture_limits.h).
struct ImportLimits {
    std::uint64_t file_bytes = 4ull << 30;  ///< the document and its buffers together
    std::uint64_t json_bytes = 1ull << 30;
    std::uint64_t json_values = 20'000'000;
    std::uint64_t vertices = 200'000'000;  ///< elements, as above
    std::uint32_t image_size_px = 16'384;  ///< width and height
};

/// Reads a glTF 2.0 file (.gltf with its buffers and images, or .glb) into plain data.
/// - The roots are those of the default scene: the first, if none is named; without scenes, nodes that have
///   no parent and are no level of detail.
/// - Missing normals are computed flat, for morph targets too; tangents only where the material has a normal
///   texture.
/// - Of more than four joints, a vertex keeps the strongest four.
/// - Clips are mended where they can be (import/gltf_keys.h), with one warning for each.
/// - EXT_mesh_gpu_instancing: instances become children behind all other nodes.
/// - A missing or broken image becomes a visible placeholder with one warning that names it.
/// - KHR_lights_punctual: lux and candela become Light::intensity by their number, unscaled.
/// - Buffers that have no data anywhere read as zeros.
/// Files are not trusted: URIs may not leave the document's folder, every offset is checked.
/// @throws Error  naming file, element, what was found and what was expected; also for required extensions
/// that are
///                not supported (optional ones are ignored with one warning each)
[[nodiscard]] Scene import_gltf(const std::filesystem::path& file, const ImportLimits& limits = {});

}  // namespace rambla::assets
