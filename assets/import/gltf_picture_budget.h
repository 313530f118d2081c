#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assets/import/gltf_document.h"

namespace rambla::assets::gltf {

/// For each of these images of a document the bytes of texels that it may have, such that all together keep
/// to most_texel_bytes of what the document, its buffers and its picture files hold: many images may refer to
/// the same few bytes.
[[nodiscard]] std::vector<std::uint64_t> texel_budgets(const Document& document,
                                                       std::span<const std::uint32_t> images);

}  // namespace rambla::assets::gltf
