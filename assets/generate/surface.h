#pragma once

#include <cstddef>
#include <cstdint>

namespace rambla::assets::generate {

/// What a triangle is made of. A model has one mesh per surface; which material stands for a surface is
/// decided where the model is put together, so that one geometry serves many colour schemes.
enum class Surface : std::uint8_t {
    wall,
    base,   ///< ground floor's wall
    trim,   ///< cornices, surrounds, sills
    plain,  ///< party walls, courtyards
    roof,
    frame,
    pane,
    pane_lit,
    shop_pane,
    shutter,
    railing,
    iron,
    door,
    timber,
    shop_frame,
    awning,
    sign,
    foliage,
    bark,
    lantern,  ///< of lamps at shops
    asphalt,
    gutter,
    kerb,
    paving,
    paint,
    cover,  ///< manholes and drains
    soil,
    body,
    car_glass,
    rubber,
    metal,
    head_lamp,
    tail_lamp,
    cloth,
    skin,
    pane_blue,       ///< lit by a television
    shop_pane_dark,  ///< of a shop that has closed
    street_lantern,
};
inline constexpr std::size_t k_surface_count = static_cast<std::size_t>(Surface::street_lantern) + 1;

/// Window panes: planar mirrors need those of each façade apart.
[[nodiscard]] constexpr bool is_pane(Surface surface) {
    return surface == Surface::pane || surface == Surface::pane_lit || surface == Surface::pane_blue ||
           surface == Surface::shop_pane || surface == Surface::shop_pane_dark;
}

/// Edge of the square that one repeat of the surface's textures covers, in metres.
[[nodiscard]] constexpr float metres_per_repeat(Surface surface) {
    switch (surface) {
        case Surface::paving:
            return 1.6f;
        case Surface::asphalt:
            return 2.0f;
        case Surface::gutter:
        case Surface::kerb:
            return 1.2f;
        case Surface::roof:
            return 2.0f;
        case Surface::shutter:
            return 1.0f;
        case Surface::shop_frame:
        case Surface::timber:
            return 1.0f;
        case Surface::bark:
            return 1.0f;
        case Surface::cloth:
            return 0.25f;
        case Surface::paint:
            return 2.0f;
        default:
            return 2.0f;
    }
}

}  // namespace rambla::assets::generate
