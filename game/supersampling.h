#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "render/gl/context.h"
#include "render/settings/anti_aliasing.h"
#include "systems/pipeline.h"

namespace rambla::game {

/// More pixels than that are not drawn: with all that a picture is made from they take 2 to 3 GB.
inline constexpr std::uint64_t k_most_drawn_px = std::uint64_t{1} << 26;

/// How many pixels are drawn for one that is shown, across and down: those that are asked for, or the most
/// that fit into textures of the device and k_most_drawn_px; 1 at least.
/// @param largest_texture_px  width and height of the largest texture
[[nodiscard]] std::uint32_t fitting_samples(std::uint32_t asked, glm::uvec2 shown_px,
                                            std::uint32_t largest_texture_px);

/// An eye as pictures with these settings want it: supersampling draws a larger picture from the Frame on, so
/// that culling, levels of detail and textures suit that. All that draws asks here. Warns, once, when samples
/// do not fit.
[[nodiscard]] systems::Eye sampled(systems::Eye eye, const render::AntiAliasingParameters& parameters,
                                   const render::DeviceInfo& device);

}  // namespace rambla::game
