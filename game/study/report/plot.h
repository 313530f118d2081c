#pragma once

#include <string>
#include <vector>

#include "game/study/report/figure.h"

namespace rambla::game::study {

/// A figure as one <svg> element for a page that has plot_style(): it scales with its box, and its text stays
/// legible down to 340 pixels of width. Points that are not finite are left out, and a note says how many.
[[nodiscard]] std::string to_svg(const Figure& figure);

/// Figures one above the other as a file of its own, style included. @param figures  at least one
[[nodiscard]] std::string to_svg_file(const std::vector<Figure>& figures);

/// The style sheet of figures, for light and dark surroundings.
[[nodiscard]] const std::string& plot_style();

}  // namespace rambla::game::study
