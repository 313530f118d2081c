#pragma once

#include <map>
#include <utility>
#include <vector>

#include "assets/generate/building.h"
#include "assets/generate/palette.h"
#include "assets/generate/shop_light.h"

namespace rambla::assets::generate {

/// Houses that a city is put together from: a few of each width, built once, shown in many colours.
class Houses {
public:
    /// Widths of houses between party walls, in metres.
    static constexpr std::array<float, 5> k_widths_m{8.0f, 9.0f, 10.0f, 12.0f, 14.0f};

    Houses(Scene& scene, const Palette& palette, const Evening& evening, std::uint64_t seed);

    /// Adds a house of this width to the scene as a root, its façade's middle at the frame's origin, facing
    /// its z.
    /// @param most_storeys  upper storeys at most; at least 3
    void add_row_house(float width_m, const Frame& at, int most_storeys, Draws& draws);
    /// Adds a corner house, the middle of its chamfer at the frame's origin.
    void add_corner_house(const Frame& at, int most_storeys, Draws& draws);

    /// Hands out the shops that have been lit since the last call; none by day.
    [[nodiscard]] std::vector<ShopWindow> take_lit_shops();

private:
    struct House {
        std::vector<StoredPart> parts;
        HouseExtras extras;
        std::vector<std::vector<GlowingGlass>> glass;  ///< of each of the lights; empty where it is dark
        FacadeStyle style;
    };
    void add(const std::vector<House>& houses, int most_storeys, const char* name, const Frame& at,
             Draws& draws);

    /// What the pane of a shop shines with, as it is drawn, and less while lamps are still going on.
    [[nodiscard]] std::vector<GlowingGlass> glowing(const FacadeLight& light) const;

    Scene& scene_;
    std::uint32_t shop_pane_;                     ///< material of lit panes
    float lamps_;                                 ///< see Evening
    float lamp_share_;                            ///< of shops, a lamp burns outside
    std::vector<std::vector<House>> row_houses_;  ///< by width
    std::vector<House> corner_houses_;
    std::vector<Scheme> plaster_schemes_, brick_schemes_;
    std::map<std::pair<const House*, std::size_t>, std::uint32_t> models_;  ///< (house, scheme)
    std::uint32_t smoke_ = k_none;
    std::uint32_t houses_added_ = 0;
    std::uint32_t lamp_ = k_none;
    std::uint32_t spot_ = k_none;
    std::uint32_t window_ = k_none;  ///< of a shop's bright window; k_none by day
    std::vector<ShopWindow> lit_shops_;
};

/// The rotation and place of a level frame as a node's transform.
[[nodiscard]] Transform transform_of(const Frame& frame);

}  // namespace rambla::assets::generate
