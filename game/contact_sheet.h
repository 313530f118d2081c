#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "assets/image.h"

namespace rambla::game {

/// Shrinks an sRGB picture to exactly `size_px`: each texel is the mean, in linear light, of the area that it
/// covers.
/// @param picture  rgba8; at least as large as `size_px` in both directions
[[nodiscard]] assets::Image shrunk(const assets::Image& picture, glm::uvec2 size_px);

/// Cells of this width show what a picture is of, and many of them fit on a screen.
inline constexpr std::uint32_t k_sheet_cell_width_px = 320;

/// Many pictures at one glance: a grid of small ones, row by row. Cells may be filled in any order, also at
/// the same time as long as each is filled by one thread.
class ContactSheet {
public:
    /// @param pictures         how many will come, at least 1
    /// @param picture_size_px  of each of them; cells keep its aspect and are never larger
    /// @param cell_width_px    what larger pictures are shrunk to
    ContactSheet(std::uint32_t pictures, glm::uvec2 picture_size_px,
                 std::uint32_t cell_width_px = k_sheet_cell_width_px);

    void place(std::uint32_t cell, const assets::Image& picture);
    [[nodiscard]] const assets::Image& image() const { return sheet_; }
    [[nodiscard]] glm::uvec2 cell_size_px() const { return cell_px_; }

private:
    glm::uvec2 cell_px_;
    std::uint32_t columns_;
    assets::Image sheet_;
};

}  // namespace rambla::game
