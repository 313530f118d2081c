#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "game/study/report/drawing.h"

namespace rambla::game::study {

/// What a line of the legend is a sample of.
struct LegendEntry {
    std::string text;
    std::optional<std::size_t> series{};  ///< whose marker is shown; none: the Pareto front
    std::size_t number = 0;               ///< of the mark that it names; 0: it names a series
    bool line = false;
};

/// Draws a legend in as many columns as its longest entry lets stand side by side.
/// @param top     of the legend, from x = left to x = right
/// @return        the legend's height; 0 without entries
double draw_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, double left, double right,
                   double top);

}  // namespace rambla::game::study
