#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "assets/image.h"
#include "assets/material.h"
#include "assets/texture_data.h"

namespace rambla::assets {

/// The alpha of a texture, as a sampler of OpenGL reads it.
struct AlphaTexture {
    struct Level {
        std::uint32_t width = 0;
        std::uint32_t height = 0;
        std::vector<float> alpha;  ///< width · height, row 0 (v = 0) first
    };
    std::vector<Level> levels;  ///< finest first, at least one, none empty
    Sampler sampler;
};

/// Alpha of a picture, without coarser levels.
/// @throws std::invalid_argument  if the picture has no texels or not as many as its size says
[[nodiscard]] AlphaTexture alpha_texture(const Image& image, const Sampler& sampler);

/// Alpha of a texture as it is drawn: decompressed, swizzled, with all its levels.
/// @throws std::invalid_argument  if it has no levels, or not the bytes of all of them (KeptLevels::all keeps
///                                them)
[[nodiscard]] AlphaTexture alpha_texture(const TextureData& texture, const Sampler& sampler);

/// KHR_texture_transform as shaders apply it: uv' = rotation(angle) · (uv · scale) + offset, where the
/// rotation counts counter-clockwise for a v axis that points down.
[[nodiscard]] glm::dvec2 transformed_uv(const TextureSlot& slot, glm::dvec2 uv);

/// Filtered alpha, OpenGL 4.5, sections 8.14 and 8.15.
/// @param texels_per_pixel  footprint: how many texels of the finest level the longer of both steps to a
///                          neighbouring pixel spans; 0: seen from next to it, infinite: the coarsest level
[[nodiscard]] double sampled_alpha(const AlphaTexture& texture, glm::dvec2 uv, double texels_per_pixel = 0.0);

}  // namespace rambla::assets
