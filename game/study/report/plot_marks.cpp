#include "game/study/report/plot_marks.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

constexpr int k_name_rings = 2;    ///< a name farther from its mark would be taken for another's
constexpr int k_number_rings = 5;  ///< a number may stand farther away, with a line to its mark

/// Places of a figure's values in its frame.
struct Canvas {
    const Axis& x;
    const Axis& y;
    const Box& frame;

    [[nodiscard]] double x_at(double value) const {
        return frame.low.x + x.place(value) * (frame.high.x - frame.low.x);
    }
    [[nodiscard]] glm::dvec2 at(const glm::dvec2& value) const {
        return {x_at(value.x), frame.high.y - y.place(value.y) * (frame.high.y - frame.low.y)};
    }
};

/// Marks that are drawn, of all series.
std::vector<const Mark*> drawn_marks(const Figure& figure) {
    std::vector<const Mark*> marks;
    for (const MarkSeries& series : figure.series)
        for (const Mark& mark : series.marks)
            if (is_drawn(mark)) marks.push_back(&mark);
    return marks;
}

/// The more there are, the smaller.
double radius_for(std::size_t marks) {
    constexpr std::size_t k_some = 60;
    constexpr std::size_t k_many = 300;
    return marks <= k_some ? 4.5 : marks <= k_many ? 3.0 : 1.8;
}

/// The front as a staircase: the best that is to be had up to each x, on to the frame's right side.
void draw_front(Drawing& drawing, const Figure& figure, const Canvas& canvas) {
    std::vector<glm::dvec2> points;
    for (const Mark* const mark : drawn_marks(figure))
        points.push_back(mark->at);
    const std::vector<bool> front = on_pareto_front(points, figure.higher_is_better);
    std::vector<glm::dvec2> steps;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (front[i]) steps.push_back(canvas.at(points[i]));
    std::sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    std::vector<glm::dvec2> stairs;
    for (const glm::dvec2& step : steps) {
        if (!stairs.empty()) stairs.emplace_back(step.x, stairs.back().y);
        stairs.push_back(step);
    }
    if (!stairs.empty()) stairs.emplace_back(canvas.frame.high.x, stairs.back().y);
    drawing.polyline(stairs, "front");
}

/// A line through a series, broken where a point is missing.
void draw_line(Drawing& drawing, const MarkSeries& series, std::size_t index, const Canvas& canvas) {
    const std::string css_class = colour_class(index).append(" line");
    std::vector<glm::dvec2> points;
    for (const Mark& mark : series.marks) {
        if (is_drawn(mark)) {
            points.push_back(canvas.at(mark.at));
        } else {
            drawing.polyline(points, css_class);
            points.clear();
        }
    }
    drawing.polyline(points, css_class);
}

bool has_whisker(const Mark& mark) {
    return std::isfinite(mark.x_low) && std::isfinite(mark.x_high) && mark.x_low < mark.x_high;
}

void draw_whisker(Drawing& drawing, const Mark& mark, std::size_t index, const Canvas& canvas) {
    if (!has_whisker(mark)) return;
    constexpr double k_half_cap = 3.0;
    const glm::dvec2 cap{0.0, k_half_cap};
    const double y = canvas.at(mark.at).y;
    const glm::dvec2 low{canvas.x_at(mark.x_low), y};
    const glm::dvec2 high{canvas.x_at(mark.x_high), y};
    const std::string css_class = colour_class(index).append(" whisker");
    drawing.line(low, high, css_class);
    drawing.line(low - cap, low + cap, css_class);
    drawing.line(high - cap, high + cap, css_class);
}

std::string hint_of(const Figure& figure, const MarkSeries& series, const Mark& mark) {
    std::string hint = mark.label.empty() ? series.name : mark.label;
    if (!hint.empty()) hint += "\n";
    hint += fmt::format("{}: {}", figure.x_label, brief(mark.at.x));
    if (has_whisker(mark)) hint += fmt::format(" ({}–{})", brief(mark.x_low), brief(mark.x_high));
    return hint.append(fmt::format("\n{}: {}", figure.y_label, brief(mark.at.y)));
}

struct Labels {
    LabelStyle style = LabelStyle::none;
    std::vector<std::string> texts;
    Placement placement;
};

Labels labels_of(const std::vector<const Mark*>& marks, LabelStyle style, const Canvas& canvas,
                 double radius) {
    Labels labels{style, {}, {}};
    std::vector<Anchor> anchors;
    for (const Mark* const mark : marks) {
        labels.texts.push_back(style == LabelStyle::names ? mark->label : std::to_string(mark->number));
        anchors.push_back({canvas.at(mark->at), {text_width(labels.texts.back()), k_text_units}});
    }
    const Box bounds{canvas.frame.low + 2.0, canvas.frame.high - 2.0};
    const int rings = style == LabelStyle::names ? k_name_rings : k_number_rings;
    labels.placement = place_labels(anchors, radius, bounds, rings);
    return labels;
}

/// Names where they have room, else numbers.
Labels best_labels(const std::vector<const Mark*>& marks, const Canvas& canvas, double radius) {
    const bool labelled = !marks.empty() && std::all_of(marks.begin(), marks.end(), [](const Mark* mark) {
        return !mark->label.empty();
    });
    if (!labelled) return {};
    const double room = canvas.frame.high.x - canvas.frame.low.x;
    Labels names = labels_of(marks, LabelStyle::names, canvas, radius);
    const bool fit = std::all_of(names.texts.begin(), names.texts.end(),
                                 [&](const std::string& text) { return text_width(text) < room / 2; });
    return fit && names.placement.free ? names : labels_of(marks, LabelStyle::numbers, canvas, radius);
}

/// The end of a line from a mark that touches the label's box.
glm::dvec2 nearest_in(const Box& box, const glm::dvec2& point) {
    return glm::clamp(point, box.low, box.high);
}

void draw_labels(Drawing& drawing, const Labels& labels, const std::vector<const Mark*>& marks,
                 const Canvas& canvas, double radius) {
    if (labels.style == LabelStyle::none) return;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const Box& box = labels.placement.boxes[i];
        const glm::dvec2 at = canvas.at(marks[i]->at);
        const glm::dvec2 end = nearest_in(box, at);
        constexpr double k_near = 8.0;
        if (glm::distance(at, end) > radius + k_near) drawing.line(at, end, "leader");
    }
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const Box& box = labels.placement.boxes[i];
        // Beside its mark, the text begins or ends there: how wide it is is only known to be less than the
        // box.
        const double x = canvas.at(marks[i]->at).x;
        const Align align = box.low.x >= x ? Align::start : box.high.x <= x ? Align::end : Align::middle;
        const double at = align == Align::start ? box.low.x
                          : align == Align::end ? box.high.x
                                                : (box.low.x + box.high.x) / 2;
        drawing.text({at, box.high.y - 0.18 * k_text_units}, align, "name", labels.texts[i]);
    }
}

template <class Count>
std::string points_text(Count count) {
    return count == 1 ? "1 point" : fmt::format("{} points", count);
}

}  // namespace

bool is_drawn(const Mark& mark) {
    return std::isfinite(mark.at.x) && std::isfinite(mark.at.y);
}

std::vector<double> x_values(const Figure& figure) {
    std::vector<double> values;
    for (const Mark* const mark : drawn_marks(figure)) {
        values.push_back(mark->at.x);
        if (has_whisker(*mark)) values.insert(values.end(), {mark->x_low, mark->x_high});
    }
    return values;
}

std::vector<double> y_values(const Figure& figure) {
    std::vector<double> values;
    for (const Mark* const mark : drawn_marks(figure))
        values.push_back(mark->at.y);
    if (figure.y_from_zero && !figure.y_log) values.push_back(0.0);
    return values;
}

std::vector<std::string> notes_of(const Figure& figure) {
    const std::vector<const Mark*> marks = drawn_marks(figure);
    std::size_t all = 0;
    for (const MarkSeries& series : figure.series)
        all += series.marks.size();
    const std::size_t missing = all - marks.size();
    const auto at_x_end = std::count_if(marks.begin(), marks.end(),
                                        [&](const Mark* mark) { return figure.x_log && mark->at.x <= 0.0; });
    const auto at_y_end = std::count_if(marks.begin(), marks.end(),
                                        [&](const Mark* mark) { return figure.y_log && mark->at.y <= 0.0; });
    std::vector<std::string> notes;
    if (marks.empty()) {
        notes.emplace_back("Nothing to draw: no point is finite.");
    } else if (missing > 0) {
        notes.push_back(fmt::format("Left out, since not finite: {}.", points_text(missing)));
    }
    if (at_x_end > 0)
        notes.push_back(fmt::format("At the left end, since not above zero: {}.", points_text(at_x_end)));
    if (at_y_end > 0)
        notes.push_back(fmt::format("At the lower end, since not above zero: {}.", points_text(at_y_end)));
    return notes;
}

LabelStyle draw_marks(Drawing& drawing, const Figure& figure, const Axis& x, const Axis& y,
                      const Box& frame) {
    const Canvas canvas{x, y, frame};
    const std::vector<const Mark*> marks = drawn_marks(figure);
    const double radius = radius_for(marks.size());
    if (figure.pareto) draw_front(drawing, figure, canvas);
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
        if (figure.series[s].line) draw_line(drawing, figure.series[s], s, canvas);
        for (const Mark& mark : figure.series[s].marks)
            if (is_drawn(mark)) draw_whisker(drawing, mark, s, canvas);
    }
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
        for (const Mark& mark : figure.series[s].marks) {
            if (!is_drawn(mark)) continue;
            drawing.marker(canvas.at(mark.at), radius, s, "mark", hint_of(figure, figure.series[s], mark));
        }
    }
    const Labels labels = best_labels(marks, canvas, radius);
    draw_labels(drawing, labels, marks, canvas, radius);
    return labels.style;
}

}  // namespace rambla::game::study
