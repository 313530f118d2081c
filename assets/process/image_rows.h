#pragma once

#include "assets/image.h"
#include "assets/material.h"
#include "assets/process/raster.h"

namespace rambla::assets {

/// A row of a picture as floats: sRGB bytes become linear light (alpha is linear always), other bytes a share
/// of 255. What is not finite counts as 0.
void read_row(const Image& picture, ColourSpace colour_space, std::uint32_t y, std::span<glm::vec4> row);

/// The vector made unit length; (0, 0, 1) where it has no direction.
[[nodiscard]] glm::vec3 unit_or_up(glm::vec3 normal);

/// Rows of unit normals, from ½ + ½ n.
[[nodiscard]] RowReader unit_normals_of(const Image& picture);

/// The reverse of read_row; values that bytes cannot hold are clamped.
[[nodiscard]] Image to_image(const Raster& raster, PixelFormat format, ColourSpace colour_space);

}  // namespace rambla::assets
