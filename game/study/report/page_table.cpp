#include "game/study/report/page_table.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "game/pass_table.h"
#include "game/study/report/figure.h"
#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

constexpr const char* k_nothing = "–";
constexpr const char* k_bytes = "B";  ///< a metric's unit whose values say it themselves
constexpr const char* k_front_mark =
    " <span class=\"star\" role=\"img\" aria-label=\"on the Pareto front\" title=\"on the Pareto "
    "front\">★</span>";

std::string cell(const char* css_class, const std::string& html) {
    return *css_class == '\0' ? fmt::format("<td>{}</td>", html)
                              : fmt::format("<td class=\"{}\">{}</td>", css_class, html);
}

/// Text that may also be broken behind the characters given, instead of anywhere.
std::string breakable(const std::string& text, const char* behind) {
    std::string html;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t at = text.find_first_of(behind, from);
        const std::size_t to = at == std::string::npos ? text.size() : at + 1;
        html += escaped(std::string_view{text}.substr(from, to - from));
        if (to < text.size()) html += "<wbr>";
        from = to;
    }
    return html;
}

/// A grade's name and mark, on one line unless the name is a long one.
std::string grade_name(const std::string& grade, bool on_front) {
    constexpr std::size_t k_long = 34;
    const char* const mark = on_front ? k_front_mark : "";
    if (length(grade) > k_long)
        return fmt::format("<span class=\"long\">{}{}</span>", breakable(grade, ":,="), mark);
    return fmt::format("<span class=\"whole\">{}{}</span>", escaped(grade), mark);
}

/// A table in a box that scrolls, under a title.
std::string block(const std::string& title, const std::string& remark, const char* css_class,
                  const std::string& rows) {
    const std::string safe = escaped(title);
    const std::string small =
        remark.empty() ? "" : fmt::format("<span class=\"small\">{}</span>", escaped(remark));
    return fmt::format(
        "<div class=\"block\"><h3>{}{}</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"{}\"><table class=\"{}\">\n{}</table></div></div>\n",
        safe, small, safe, css_class, rows);
}

/// The scene's metrics in the order in which its grades first name them.
std::vector<const Metric*> metrics_of(const SceneGrades& scene) {
    std::vector<const Metric*> metrics;
    for (const GradeResult& grade : scene.grades) {
        for (const Metric& metric : grade.metrics) {
            const bool known = std::any_of(metrics.begin(), metrics.end(),
                                           [&](const Metric* other) { return other->name == metric.name; });
            if (!known) metrics.push_back(&metric);
        }
    }
    return metrics;
}

std::string head_row(const std::vector<const Metric*>& metrics) {
    std::string html =
        "<thead><tr><th class=\"number\">#</th><th class=\"name\" scope=\"col\">grade</th><th "
        "scope=\"col\">ms</th>"
        "<th scope=\"col\">10–90 %</th><th scope=\"col\">× cheapest</th><th scope=\"col\">10–90 %</th>"
        "<th scope=\"col\">memory</th>";
    for (const Metric* const metric : metrics) {
        const bool no_unit = metric->unit.empty() || metric->unit == k_bytes;
        const std::string unit = no_unit ? "" : fmt::format("<br>{}", escaped(metric->unit));
        html +=
            fmt::format("<th class=\"metric\" scope=\"col\">{}{}</th>", breakable(metric->name, "_"), unit);
    }
    return html.append("</tr></thead>\n");
}

std::string interval(const std::optional<Spread>& spread, const std::string& low, const std::string& high) {
    return cell("muted", spread ? fmt::format("{}–{}", low, high) : k_nothing);
}

std::string time_cells(const std::optional<Spread>& ms, double dearest) {
    if (!ms) return cell("", k_nothing).append(cell("muted", k_nothing));
    const double share = dearest > 0.0 ? ms->median / dearest : 0.0;
    return fmt::format("<td><span class=\"bar\" style=\"--share:{:.3f}\">{}</span></td>", share,
                       brief(ms->median))
        .append(interval(ms, brief(ms->low), brief(ms->high)));
}

std::string ratio_text(double ratio) {
    constexpr double k_large = 100.0;
    return ratio < k_large ? fmt::format("{:.2f}", ratio) : brief(ratio);
}

std::string ratio_cells(const Timing& timing) {
    if (!timing.ratio) return cell("", k_nothing).append(cell("muted", k_nothing));
    const Spread& ratio = *timing.ratio;
    // The cheapest is 1 by definition; a spread of it would say nothing.
    const std::string spread =
        timing.cheapest ? k_nothing : fmt::format("{}–{}", ratio_text(ratio.low), ratio_text(ratio.high));
    return cell("", ratio_text(ratio.median)).append(cell("muted", spread));
}

std::string memory_cell(double bytes) {
    const bool known = std::isfinite(bytes) && bytes >= 0.0;
    return cell("", known ? bytes_text(bytes) : k_nothing);
}

std::string metric_text(const Metric& metric) {
    if (metric.unit != k_bytes || !std::isfinite(metric.value)) return brief(metric.value);
    return fmt::format("{}{}", metric.value < 0.0 ? "−" : "", bytes_text(std::abs(metric.value)));
}

std::string metric_cells(const GradeResult& grade, const std::vector<const Metric*>& metrics) {
    std::string html;
    for (const Metric* const column : metrics) {
        const Metric* const metric = find_metric(grade, column->name);
        html += cell("", metric != nullptr ? metric_text(*metric) : k_nothing);
    }
    return html;
}

/// Which grades are on the front of the plotted metric against milliseconds.
std::vector<bool> front_of(const SceneGrades& scene, const std::string& plotted_metric) {
    std::vector<glm::dvec2> points(scene.grades.size(), glm::dvec2{NAN});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Metric* const metric = find_metric(scene.grades[i], plotted_metric);
        if (metric != nullptr && scene.timings[i].ms)
            points[i] = {scene.timings[i].ms->median, metric->value};
    }
    return on_pareto_front(points, higher_is_better(plotted_metric));
}

double dearest_of(const SceneGrades& scene) {
    double dearest = 0.0;
    for (const Timing& timing : scene.timings)
        if (timing.ms) dearest = std::max(dearest, timing.ms->median);
    return dearest;
}

/// "15 rounds", or "10 to 15 rounds"; empty for a scene that was not timed.
std::string rounds_text(const SceneGrades& scene) {
    std::size_t fewest = 0;
    std::size_t most = 0;
    for (const GradeResult& grade : scene.grades) {
        if (grade.ms.empty()) continue;
        fewest = fewest == 0 ? grade.ms.size() : std::min(fewest, grade.ms.size());
        most = std::max(most, grade.ms.size());
    }
    if (most == 0) return "not timed";
    if (most == 1) return "1 round";
    return fewest == most ? fmt::format("{} rounds", most) : fmt::format("{} to {} rounds", fewest, most);
}

bool looks_like_a_number(const std::string& text) {
    const std::size_t first = text.find_first_not_of("+-");
    if (first == std::string::npos) return true;  // empty, or a dash for nothing
    return (text[first] >= '0' && text[first] <= '9') || text.starts_with("−") || text == k_nothing;
}

bool is_number_column(const Table& table, std::size_t column) {
    return std::all_of(table.rows.begin(), table.rows.end(), [&](const std::vector<std::string>& row) {
        return column >= row.size() || looks_like_a_number(row[column]);
    });
}

}  // namespace

std::string grades_block(const SceneGrades& scene, const std::string& plotted_metric) {
    const std::vector<const Metric*> metrics = metrics_of(scene);
    const std::vector<bool> front = front_of(scene, plotted_metric);
    const double dearest = dearest_of(scene);
    std::string rows = head_row(metrics).append("<tbody>\n");
    for (std::size_t i = 0; i < scene.grades.size(); ++i) {
        const GradeResult& grade = scene.grades[i];
        const Timing& timing = scene.timings[i];
        rows += fmt::format("<tr{}><td class=\"number\">{}</td><th class=\"name\" scope=\"row\">{}{}</th>",
                            front[i] ? " class=\"front\"" : "", i + 1, grade_name(grade.grade, front[i]),
                            timing.cheapest ? " <span class=\"tag\">cheapest</span>" : "");
        rows.append(time_cells(timing.ms, dearest)).append(ratio_cells(timing));
        rows.append(memory_cell(grade.bytes)).append(metric_cells(grade, metrics)).append("</tr>\n");
    }
    return block(scene.scene, rounds_text(scene), "grades", rows.append("</tbody>"));
}

std::string table_block(const Table& table) {
    std::string rows = "<thead><tr>";
    std::vector<const char*> classes;
    for (std::size_t column = 0; column < table.head.size(); ++column) {
        classes.push_back(column > 0 && is_number_column(table, column) ? "" : "name");
        rows += fmt::format("<th class=\"{}\" scope=\"col\">{}</th>", classes.back(),
                            escaped(table.head[column]));
    }
    rows += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : table.rows) {
        rows += "<tr>";
        for (std::size_t column = 0; column < row.size() && column < classes.size(); ++column) {
            rows += column == 0 ? fmt::format("<th class=\"name\" scope=\"row\">{}</th>", escaped(row[0]))
                                : cell(classes[column], escaped(row[column]));
        }
        rows += "</tr>\n";
    }
    return block(table.title, "", "further", rows.append("</tbody>"));
}

}  // namespace rambla::game::study
