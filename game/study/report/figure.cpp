#include "game/study/report/figure.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "game/study/report/timing.h"

namespace rambla::game::study {
namespace {

/// Where the largest positive value is this many times the smallest, a linear axis would press most points
/// into one corner.
constexpr double k_log_from = 10.0;

bool is_finite(const glm::dvec2& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

/// Whether values spread so far that their logarithm is drawn. Negative ones have none.
bool wants_log(const std::vector<double>& values) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const double value : values) {
        if (value < 0.0) return false;
        if (value > 0.0) low = std::min(low, value);
        high = std::max(high, value);
    }
    return high >= k_log_from * low;
}

std::string label_of(const Metric& metric) {
    return metric.unit.empty() ? metric.name : fmt::format("{} ({})", metric.name, metric.unit);
}

MarkSeries& series_named(Figure& figure, const std::string& name) {
    for (MarkSeries& series : figure.series)
        if (series.name == name) return series;
    return figure.series.emplace_back(MarkSeries{name});
}

Figure error_figure(const SceneGrades& scene, const std::string& metric_name) {
    Figure figure{.title = scene.scene, .x_label = "milliseconds", .y_label = metric_name};
    figure.pareto = true;
    figure.higher_is_better = higher_is_better(metric_name);
    figure.y_from_zero = !figure.higher_is_better;
    std::vector<double> times;
    std::vector<double> values;
    for (std::size_t i = 0; i < scene.grades.size(); ++i) {
        const GradeResult& grade = scene.grades[i];
        const std::optional<Spread>& ms = scene.timings[i].ms;
        const Metric* const metric = find_metric(grade, metric_name);
        if (!ms || metric == nullptr) continue;
        figure.y_label = label_of(*metric);
        series_named(figure, grade.grade.substr(0, grade.grade.find(':')))
            .marks.push_back({{ms->median, metric->value}, ms->low, ms->high, grade.grade, i + 1});
        if (!std::isfinite(metric->value)) continue;
        times.push_back(ms->median);
        values.push_back(metric->value);
    }
    figure.x_log = wants_log(times);
    figure.y_log = wants_log(values);
    return figure;
}

}  // namespace

Figure to_figure(const Plot& plot) {
    Figure figure{plot.title, plot.x_label, plot.y_label, plot.x_log, plot.y_log, plot.pareto};
    for (const Series& series : plot.series) {
        MarkSeries& marks = figure.series.emplace_back(MarkSeries{series.name, {}, series.line});
        for (const glm::dvec2& point : series.points)
            marks.marks.push_back({point, point.x, point.x});
    }
    return figure;
}

std::vector<Figure> error_figures(const StudyResult& result) {
    std::vector<Figure> figures;
    if (result.plotted_metric.empty()) return figures;
    for (const SceneGrades& scene : by_scene(result)) {
        Figure figure = error_figure(scene, result.plotted_metric);
        if (!figure.series.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

std::vector<Figure> figures_of(const StudyResult& result) {
    std::vector<Figure> figures = error_figures(result);
    for (const Plot& plot : result.plots)
        figures.push_back(to_figure(plot));
    return figures;
}

bool has_marks(const Figure& figure) {
    for (const MarkSeries& series : figure.series)
        for (const Mark& mark : series.marks)
            if (is_finite(mark.at)) return true;
    return false;
}

bool higher_is_better(const std::string& metric) {
    return metric.starts_with("psnr");
}

std::vector<bool> on_pareto_front(const std::vector<glm::dvec2>& points, bool higher_is_better) {
    std::vector<bool> front(points.size(), false);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t i) { return !is_finite(points[i]); });
    const auto badness = [&](std::size_t i) {
        return higher_is_better ? -points[i].y : points[i].y;
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].x != points[b].x ? points[a].x < points[b].x : badness(a) < badness(b);
    });
    // From left to right, a point is on the front if it is better than all before it, or the same as the last
    // one.
    double best = std::numeric_limits<double>::infinity();
    double best_x = 0.0;
    for (const std::size_t i : order) {
        const bool same = badness(i) == best && points[i].x == best_x;
        if (badness(i) >= best && !same) continue;
        front[i] = true;
        best = badness(i);
        best_x = points[i].x;
    }
    return front;
}

}  // namespace rambla::game::study
