#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "game/study/picture.h"

namespace rambla::game::study {

/// Pixels of a picture by what anti-aliasing should do there: all it can, or nothing. What lies between the
/// two belongs to neither. Per pixel, row-major, not 0 where it is one.
struct PixelRegions {
    std::vector<std::uint8_t> edges;
    std::vector<std::uint8_t> textures;
};

/// @param is_edge      per pixel, not 0 where geometry has an edge
/// @param within_px    pixels up to this far from an edge, between centres, belong to `edges`
/// @param farther_px   those farther than this to `textures`; ≥ within_px
[[nodiscard]] PixelRegions pixel_regions(glm::uvec2 size_px, std::span<const std::uint8_t> is_edge,
                                         double within_px, double farther_px);

/// Root of the mean squared difference of what a display is sent (sRGB-encoded, 0 to 1), over the three
/// channels of a region's pixels. 0 for a region without pixels.
/// @throws std::invalid_argument when pictures or region differ in size
[[nodiscard]] double rms_display(const Picture& reference, const Picture& test,
                                 std::span<const std::uint8_t> region);

/// Mean of a map of one value per pixel over a region; 0 for a region without pixels.
[[nodiscard]] double mean_within(std::span<const float> map, std::span<const std::uint8_t> region);

/// Mean over a region of the standard deviation of what a display is sent for luminance (sRGB-encoded, 0 to
/// 1) in the 3×3 pixels about each pixel: what detail there is to see. The outermost pixels of the picture,
/// which have fewer neighbours, do not count.
/// @throws std::invalid_argument when picture and region differ in size
[[nodiscard]] double local_contrast(const Picture& picture, std::span<const std::uint8_t> region);

}  // namespace rambla::game::study
