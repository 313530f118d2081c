#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "game/study/picture.h"

namespace rambla::game::study {

/// What counts as wrong, and where an error at an edge ends.
struct WrongPixelLimits {
    double tolerance = 0.0;  ///< values that differ by no more are equal, in their own unit; ≥ 0
    double edge_px = 1.0;    ///< pixels up to this far from an edge of the reference belong to it; ≥ 0
};

struct WrongPixels {
    double wrong_pixels_pct = 0.0;       ///< of all pixels, 0 to 100
    double wrong_beyond_edge_pct = 0.0;  ///< wrong and farther than edge_px from an edge; of all pixels too
};

/// Share of pixels whose value is not the reference's, and of those among them that no true edge is near to.
/// An edge pixel is one with a 4-neighbour of another value (by more than the tolerance), so both sides of
/// a boundary are edge; distances are Euclidean between pixel centres and exact. Without an edge every
/// wrong pixel lies beyond it. NaN differs from every number and equals NaN, infinities equal themselves.
/// @param size_px          width and height; nothing is wrong in a picture of no pixels
/// @param reference, test  row-major, e.g. 0 for shadowed and 1 for lit
/// @throws std::invalid_argument saying the size and both counts when those are not width · height
/// Not symmetric: the edges are the reference's.
[[nodiscard]] WrongPixels wrong_pixels(glm::uvec2 size_px, std::span<const float> reference,
                                       std::span<const float> test, WrongPixelLimits limits = {});

/// The same of labels, e.g. object ids, which are equal or not.
/// @param edge_px  see WrongPixelLimits
[[nodiscard]] WrongPixels wrong_pixels(glm::uvec2 size_px, std::span<const std::uint32_t> reference,
                                       std::span<const std::uint32_t> test, double edge_px = 1.0);

/// Share of pixels of which a channel differs by more than the tolerance (linear light), in percent. A texel
/// that is not finite in one picture alone is wrong.
/// @throws std::invalid_argument saying both sizes when they differ
[[nodiscard]] double wrong_pixels_pct(const Picture& reference, const Picture& test, double tolerance);

}  // namespace rambla::game::study
