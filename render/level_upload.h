#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "assets/texture_data.h"
#include "render/gl/texture.h"

namespace rambla::render {

/// What a texture is like that holds an image's levels from `first` on.
[[nodiscard]] gl::TextureDesc describe_levels(const assets::TextureData& image, std::uint32_t first);

/// A texture for the levels from `first` on, still without texels, that gives shaders the channels they ask
/// for. Its level 0 is the image's level `first`.
[[nodiscard]] gl::Texture make_level_texture(const assets::TextureData& image, std::uint32_t first);

/// Rows of a level that are uploaded together at least: of a block where there are blocks.
[[nodiscard]] std::uint32_t row_step(const assets::TextureData& image);
/// Bytes of so many rows.
[[nodiscard]] std::size_t row_step_bytes(const assets::TextureData& image, std::uint32_t level);

/// Fills rows of a level of an image. Row 0, its top, becomes the texture's first row, so that v = 0 is the
/// top as glTF has it.
/// @param first      the image's level that is the texture's level 0
/// @param bytes      of the whole level
/// @param first_row  a multiple of row_step()
void upload_rows(const gl::Texture& texture, std::uint32_t first, const assets::TextureData& image,
                 std::uint32_t level, std::span<const std::byte> bytes, std::uint32_t first_row,
                 std::uint32_t row_count);

/// Copies all levels from `level` on from one texture of an image to another, on the graphics card.
/// @param from_first, to_first  the image's levels that are the textures' levels 0
void copy_levels(const gl::Texture& from, std::uint32_t from_first, const gl::Texture& to,
                 std::uint32_t to_first, const assets::TextureData& image, std::uint32_t level);

}  // namespace rambla::render
