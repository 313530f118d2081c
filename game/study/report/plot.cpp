#include "game/study/report/plot.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "game/study/report/axis.h"
#include "game/study/report/drawing.h"
#include "game/study/report/label_placement.h"
#include "game/study/report/plot_legend.h"
#include "game/study/report/plot_marks.h"
#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

constexpr double k_width = 440.0;
constexpr double k_frame_height = 232.0;
constexpr double k_edge = 6.0;  ///< kept free all around
constexpr double k_line = 16.0;

/// A figure that is drawn but for its <svg> element.
struct Drawn {
    std::string svg;
    double height = 0.0;
};

/// Lines of text from the left edge. @return  the top of what comes below
double draw_lines(Drawing& drawing, const std::string& text, const char* css_class, double top,
                  std::size_t most_lines) {
    const auto characters = static_cast<std::size_t>((k_width - 2 * k_edge) / k_character_units);
    for (const std::string& line : wrapped(text, characters, most_lines)) {
        drawing.text({k_edge, top + k_text_units}, Align::start, css_class, line);
        top += k_line;
    }
    return top;
}

double widest_label(const Axis& axis) {
    double widest = 0.0;
    for (const Tick& tick : axis.ticks)
        widest = std::max(widest, text_width(tick.label));
    return widest;
}

void draw_y_axis(Drawing& drawing, const Axis& axis, const Box& frame) {
    constexpr double k_minor = 3.0;
    for (const Tick& tick : axis.ticks) {
        const double y = frame.high.y - axis.place(tick.value) * (frame.high.y - frame.low.y);
        if (tick.label.empty()) {
            drawing.line({frame.low.x - k_minor, y}, {frame.low.x, y}, "tick");
            continue;
        }
        drawing.line({frame.low.x, y}, {frame.high.x, y}, "grid");
        drawing.text({frame.low.x - 6.0, y + 0.35 * k_text_units}, Align::end, "value", tick.label);
    }
    drawing.line(frame.low, {frame.low.x, frame.high.y}, "axis");
}

void draw_x_axis(Drawing& drawing, const Axis& axis, const Box& frame) {
    constexpr double k_minor = 3.0;
    for (const Tick& tick : axis.ticks) {
        const double x = frame.low.x + axis.place(tick.value) * (frame.high.x - frame.low.x);
        if (tick.label.empty()) {
            drawing.line({x, frame.high.y}, {x, frame.high.y + k_minor}, "tick");
            continue;
        }
        drawing.line({x, frame.low.y}, {x, frame.high.y}, "grid");
        // The outermost labels stay inside the picture.
        const double half = text_width(tick.label) / 2;
        const double middle = std::clamp(x, k_edge + half, k_width - k_edge - half);
        drawing.text({middle, frame.high.y + 16.0}, Align::middle, "value", tick.label);
    }
    drawing.line({frame.low.x, frame.high.y}, frame.high, "axis");
}

/// Series with a name, where there is more than one or it says something; with numbers instead the labels'
/// key.
std::vector<LegendEntry> legend_of(const Figure& figure, LabelStyle labels) {
    std::vector<LegendEntry> entries;
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
        const MarkSeries& series = figure.series[s];
        if (labels == LabelStyle::none && !series.name.empty())
            entries.push_back({series.name, s, 0, series.line});
        if (labels != LabelStyle::numbers) continue;
        for (const Mark& mark : series.marks)
            if (is_drawn(mark)) entries.push_back({mark.label, s, mark.number});
    }
    if (labels == LabelStyle::numbers) {
        std::stable_sort(entries.begin(), entries.end(),
                         [](const LegendEntry& a, const LegendEntry& b) { return a.number < b.number; });
    }
    if (figure.pareto && has_marks(figure)) entries.push_back({"Pareto front"});
    return entries;
}

Drawn draw(const Figure& figure) {
    Drawing drawing;
    double top = draw_lines(drawing, figure.title, "title", k_edge, 3);
    for (const std::string& note : notes_of(figure))
        top = draw_lines(drawing, note, "note", top, 3);
    top = draw_lines(drawing, figure.y_label, "value", top + 4.0, 2) + 6.0;

    const Axis y = make_axis(y_values(figure), figure.y_log, k_frame_height, Direction::vertical);
    const Box frame{{k_edge + widest_label(y) + 8.0, top}, {k_width - k_edge - 8.0, top + k_frame_height}};
    const Axis x =
        make_axis(x_values(figure), figure.x_log, frame.high.x - frame.low.x, Direction::horizontal);
    drawing.rectangle(frame.low, frame.high, "frame");
    draw_y_axis(drawing, y, frame);
    draw_x_axis(drawing, x, frame);
    const LabelStyle labels = draw_marks(drawing, figure, x, y, frame);

    double bottom = frame.high.y + 20.0;
    for (const std::string& line : wrapped(figure.x_label, 50, 2)) {
        drawing.text({frame.high.x, bottom + k_text_units}, Align::end, "value", line);
        bottom += k_line;
    }
    bottom += 6.0;
    bottom += draw_legend(drawing, legend_of(figure, labels), k_edge, k_width - k_edge, bottom);
    return {drawing.svg(), bottom + k_edge};
}

std::string element(const Figure& figure, const Drawn& drawn, const std::string& place) {
    return fmt::format(
        "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\"{} width=\"{}\" height=\"{}\" viewBox=\"0 0 "
        "{} {}\" "
        "role=\"img\" aria-label=\"{}\">\n{}</svg>\n",
        place, k_width, drawn.height, k_width, drawn.height,
        escaped(fmt::format("{}: {} over {}", figure.title, figure.y_label, figure.x_label)), drawn.svg);
}

}  // namespace

std::string to_svg(const Figure& figure) {
    return element(figure, draw(figure), "");
}

std::string to_svg_file(const std::vector<Figure>& figures) {
    std::string parts;
    double height = 0.0;
    for (const Figure& figure : figures) {
        const Drawn drawn = draw(figure);
        parts += element(figure, drawn, fmt::format(" y=\"{}\"", height));
        height += drawn.height;
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\">\n<style>{2}"
        "</style>\n<g class=\"plot\"><rect class=\"paper\" width=\"{0}\" height=\"{1}\"/></g>\n{3}</svg>\n",
        k_width, height, plot_style(), parts);
}

}  // namespace rambla::game::study
