#include "game/study/report/plot_legend.h"

#include <algorithm>
#include <cmath>

#include "game/study/report/axis.h"
#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

constexpr double k_row_units = 17.0;
constexpr double k_sample_units = 20.0;  ///< for the marker or the line, and the gap behind it
constexpr double k_number_units = 22.0;
constexpr double k_column_gap_units = 12.0;
constexpr double k_radius = 4.5;

/// Where an entry's text begins.
double text_start(const LegendEntry& entry) {
    return k_sample_units + (entry.number > 0 ? k_number_units : 0.0);
}

double width_of(const LegendEntry& entry) {
    return text_start(entry) + text_width(entry.text);
}

void draw_entry(Drawing& drawing, const LegendEntry& entry, const glm::dvec2& at, double width) {
    const glm::dvec2 middle = at + glm::dvec2{k_radius, k_row_units / 2};
    const double baseline = at.y + k_row_units / 2 + k_text_units * 0.35;
    const glm::dvec2 half_line{k_sample_units / 2 - 2.0, 0.0};
    if (!entry.series) {
        drawing.line(middle - half_line + 4.0 * glm::dvec2{1, 0}, middle + half_line + 4.0 * glm::dvec2{1, 0},
                     "front");
    } else {
        if (entry.line)
            drawing.line(middle - half_line, middle + half_line, colour_class(*entry.series).append(" line"));
        drawing.marker(middle, k_radius, *entry.series, "sample", "");
    }
    if (entry.number > 0)
        drawing.text({at.x + text_start(entry) - 5.0, baseline}, Align::end, "key",
                     std::to_string(entry.number));
    const auto characters =
        static_cast<std::size_t>(std::max(4.0, std::floor((width - text_start(entry)) / k_character_units)));
    const std::vector<std::string> lines = wrapped(entry.text, characters, 1);
    drawing.text({at.x + text_start(entry), baseline}, Align::start, "key",
                 lines.empty() ? "" : lines.front());
}

}  // namespace

double draw_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, double left, double right,
                   double top) {
    if (entries.empty()) return 0.0;
    double widest = 0.0;
    for (const LegendEntry& entry : entries)
        widest = std::max(widest, width_of(entry) + k_column_gap_units);
    const double room = right - left + k_column_gap_units;
    const auto columns = static_cast<std::size_t>(
        std::clamp(std::floor(room / widest), 1.0, static_cast<double>(entries.size())));
    const std::size_t rows = (entries.size() + columns - 1) / columns;
    const double column_width = room / static_cast<double>(columns);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        // Downwards first, so that numbers are found where one looks for them.
        const glm::dvec2 cell{static_cast<double>(i / rows) * column_width,
                              static_cast<double>(i % rows) * k_row_units};
        draw_entry(drawing, entries[i], glm::dvec2{left, top} + cell, column_width - k_column_gap_units);
    }
    return static_cast<double>(rows) * k_row_units;
}

}  // namespace rambla::game::study
