#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "systems/frame.h"

namespace rambla::render {

/// Pictures after which the offsets of the samples repeat. The mean of a few pictures, weighted by their age,
/// has to tell how much of a pixel is covered: more of them know steep edges better, but weigh the oldest
/// ones less, so that edges shimmer with the sequence. Of 4 to 32, 8 has the least sum of both errors at the
/// usual share of earlier pictures.
inline constexpr std::uint32_t k_jitter_length = 8;

/// Where within a pixel picture number `index` samples: points of Halton's sequence in the bases 2 and 3,
/// shifted so that the mean of the k_jitter_length of them is the middle: a still picture must not drift.
/// @return  in (−½, ½)², from the pixel's middle
[[nodiscard]] glm::vec2 jitter_px(std::uint32_t index);

/// The view with the picture moved by so many pixels, to the right and upwards.
[[nodiscard]] systems::FrameView shifted(const systems::FrameView& view, glm::vec2 offset_px);

/// The view with so many pixels more on each side, squeezed into the same picture: it holds all that the view
/// shows if it is shifted by up to `border_px`.
[[nodiscard]] systems::FrameView widened(const systems::FrameView& view, float border_px);

}  // namespace rambla::render
