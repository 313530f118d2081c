#include "assets/generate/textures.h"

#include <tbb/parallel_for.h>

#include <array>

namespace rambla::assets::generate {

namespace {

using Painter = PaintedSet (*)(std::uint32_t);

constexpr std::array<Painter, k_pattern_count> k_painters{
    paint_plaster, paint_brick,      paint_stone,  paint_stucco, paint_paving,     paint_asphalt,
    paint_granite, paint_gravel,     paint_louvre, paint_timber, paint_door,       paint_bark,
    paint_leaves,  paint_railing,    paint_fabric, paint_window, paint_window_lit, paint_shop,
    paint_signs,   paint_road_paint, paint_cover,  paint_cloth,
};

}  // namespace

PaintedSet paint_pattern(Pattern pattern, std::uint32_t seed) {
    return k_painters[static_cast<std::size_t>(pattern)](seed);
}

std::vector<PaintedSet> paint_all_patterns(std::uint32_t seed) {
    std::vector<PaintedSet> sets(k_pattern_count);
    tbb::parallel_for(std::size_t{0}, k_pattern_count, [&](std::size_t i) {
        sets[i] = paint_pattern(static_cast<Pattern>(i), seed + static_cast<std::uint32_t>(i) * 1000u);
    });
    return sets;
}

}  // namespace rambla::assets::generate
