#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "assets/generate/canvas.h"
#include "assets/image.h"

namespace rambla::assets::generate {

/// The texture sets of a street. All tile but those that are cut into cells (leaves, windows, signs).
enum class Pattern : std::uint8_t {
    plaster,
    brick,
    stone,
    stucco,
    paving,
    asphalt,
    granite,
    gravel,
    louvre,
    timber,
    door,
    bark,
    leaves,
    railing,
    fabric,
    window,
    window_lit,
    shop,
    signs,
    paint,
    cover,
    cloth,
};
inline constexpr std::size_t k_pattern_count = static_cast<std::size_t>(Pattern::cloth) + 1;

/// One painted set. Colours and emission are sRGB, the others linear.
struct PaintedSet {
    std::string name;
    Image colour;
    std::optional<Image> normal;     ///< green points up the image
    std::optional<Image> roughness;  ///< in G; B (metalness) is 0
    std::optional<Image> emission;
    std::optional<Relief> relief{};  ///< of those that are as high as wide, and deep enough to be seen
};

/// Cells of the window and shop patterns from left to right, and of the sign pattern from top to bottom.
inline constexpr std::uint32_t k_window_cells = 4;
inline constexpr std::uint32_t k_shop_cells = 4;
inline constexpr std::uint32_t k_sign_cells = 8;
inline constexpr std::uint32_t k_leaf_cells = 2;  ///< squares of the leaf pattern from left to right

/// Paints one set; the same pattern and seed give the same bytes.
[[nodiscard]] PaintedSet paint_pattern(Pattern pattern, std::uint32_t seed);

/// Paints all sets, in parallel, in the order of Pattern.
[[nodiscard]] std::vector<PaintedSet> paint_all_patterns(std::uint32_t seed);

// Painters of the groups, one file each.
[[nodiscard]] PaintedSet paint_plaster(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_brick(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_stone(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_stucco(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_paving(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_asphalt(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_granite(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_gravel(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_road_paint(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_cover(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_louvre(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_timber(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_door(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_bark(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_leaves(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_railing(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_fabric(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_window(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_window_lit(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_shop(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_signs(std::uint32_t seed);
[[nodiscard]] PaintedSet paint_cloth(std::uint32_t seed);

}  // namespace rambla::assets::generate
