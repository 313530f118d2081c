#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/passes/light_rectangle.h"
#include "render/shaders/shared/light_cells.h"
#include "systems/frame.h"

namespace rambla::render {

/// A light that can touch the picture, and where.
struct BoundedLight {
    std::uint32_t light = 0;  ///< row of the Frame's lights
    ScreenRectangle bounds;
};

/// Lights reach no farther than this: bounds of larger ones would lose all digits, or be no numbers at all.
inline constexpr float k_farthest_light_m = 1e6f;

/// Replaces `found` by the lights that can touch the picture, in their order.
void bound_lights(const systems::FrameView& view, std::span<const systems::FrameLight> lights,
                  std::vector<BoundedLight>& found);

/// Lists of lights, one for each cell of the screen: tiles in rows from the lower left one on, each tile's
/// slices of depth one after the other, from the nearest on.
///
///      tile              Slices grow with the distance, so that a cell is about as deep as wide:
///     ┌────┬────┬────┐     0    1 m   √2    2   2·√2   4 …   256 m
///     │    │    │ 2  │     ├─────┼────┼─────┼─────┼────┼─────────┤ … the last one has no end
///     ├────┼────┼────┤     slice 0    1     2     3
///     │ 0  │ 1  │    │
///     └────┴────┴────┘   (here with two slices for each doubling)
///
/// Clustered shading: Olsson, Billeter, Assarsson 2012, section 3; with cells of tiles alone, tiled shading:
/// Olsson, Assarsson 2011.
struct LightBins {
    shared::LightGrid grid{};
    std::vector<glm::uvec2> ranges;      ///< per cell: first entry and number of entries
    std::vector<std::uint32_t> entries;  ///< rows of the Frame's lights, ascending in each cell
};

/// Lists that would hold more than this, in all, are made for larger cells instead: half as many slices, then
/// tiles twice as wide. Down to a single cell, which holds each light once.
inline constexpr std::uint64_t k_most_light_entries = 4u << 20;
/// And of cells themselves, of which each has a range of 8 bytes.
inline constexpr std::uint64_t k_most_light_cells = 1u << 20;

/// Sorts lights into cells. Keeps its memory.
class LightBinner {
public:
    /// No cell lacks a light that reaches one of its points.
    /// @param tile_px  > 0; of the smallest tiles
    /// @param slices   > 0; the most
    /// @return         valid until the next call
    [[nodiscard]] const LightBins& bin(glm::uvec2 size_px, std::span<const BoundedLight> lights,
                                       std::uint32_t tile_px, std::uint32_t slices);

private:
    LightBins bins_;
};

}  // namespace rambla::render
