#pragma once

#include <array>
#include <vector>

#include "assets/generate/city_plan.h"
#include "assets/generate/palette.h"

namespace rambla::assets::generate {

/// Everything that stands along kerbs, built once and placed as nodes.
class StreetThings {
public:
    StreetThings(Scene& scene, const Palette& palette, const StreetPlan& plan, const Evening& evening,
                 std::uint64_t seed);

    enum class Thing : std::uint8_t {
        tree_a,
        tree_b,
        tree_c,
        tree_pit,
        lamp_post,
        wall_lantern,
        bench,
        bollard,
        litter_bin,
        manhole,
        drain,
        crossing
    };
    static constexpr std::size_t k_things = static_cast<std::size_t>(Thing::crossing) + 1;

    /// Adds one as a root of the scene, its foot at the frame's origin; a lantern with its light, if that
    /// burns.
    void add(Thing thing, const Frame& at);
    /// Furnishes one side of a block: the frame stands on the pavement at the middle of the side's façade
    /// line, its z towards the street. Sides with trees have benches and bins, the others lamp posts.
    void furnish_side(const Frame& at, float length_m, bool trees, Draws& draws);
    /// Bollards about a chamfer's kerb.
    void furnish_corner(const Frame& at);

private:
    Scene& scene_;
    StreetPlan plan_;
    std::array<std::uint32_t, k_things> models_{};
    std::uint32_t post_light_ = k_none;  ///< k_none by day
    std::uint32_t wall_light_ = k_none;
    /// About a lantern, bright and near and faint and far, as what the air scatters falls off; none by day.
    std::vector<std::uint32_t> glows_;
    std::uint32_t manholes_added_ = 0;
    std::uint32_t vapour_ = k_none;  ///< k_none by day, when it is warm
};

}  // namespace rambla::assets::generate
