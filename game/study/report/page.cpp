#include "game/study/report/page.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "game/study/report/figure.h"
#include "game/study/report/page_pictures.h"
#include "game/study/report/page_style.h"
#include "game/study/report/page_table.h"
#include "game/study/report/plot.h"
#include "game/study/report/text.h"
#include "game/study/report/timing.h"

namespace rambla::game::study {
namespace {

constexpr const char* k_introduction =
    "<p class=\"kicker\">Rambla studies</p>\n<h1>What accuracy costs in time</h1>\n"
    "<p class=\"lead\">Each study does the same work with every grade of a technique, and compares the "
    "result with a "
    "reference that is right by construction.</p>\n"
    "<p>Times are medians over rounds in which the grades take turns; beside them stands the interval from "
    "the 10 % "
    "to the 90 % percentile. The ratio to the cheapest grade is taken within each round, so that a slower "
    "moment of "
    "the machine does not count. A <span class=\"star\">★</span> marks the Pareto front: no grade is both "
    "cheaper and "
    "nearer to the reference. Numbers in the figures are those of the tables’ rows.</p>\n";

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0.0) return "an unknown time";
    constexpr double k_minute = 60.0;
    constexpr double k_hour = 3600.0;
    if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
    const double whole = std::round(seconds);
    if (whole < k_minute) return fmt::format("{:.0f} s", whole);
    if (whole < k_hour)
        return fmt::format("{:.0f} min {:.0f} s", std::floor(whole / k_minute), std::fmod(whole, k_minute));
    const double minutes = std::round(seconds / k_minute);
    return fmt::format("{:.0f} h {:.0f} min", std::floor(minutes / k_minute), std::fmod(minutes, k_minute));
}

std::string paragraph(const char* css_class, const std::string& html) {
    return fmt::format("<p class=\"{}\">{}</p>\n", css_class, html);
}

std::string facts_list(const RunFacts& facts) {
    if (facts.empty()) return {};
    std::string html = "<dl class=\"facts\">\n";
    for (const auto& fact : facts)
        html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(fact.first), escaped(fact.second));
    return html.append("</dl>\n");
}

/// What a section's run depends on otherwise than the page's. Empty if it is of the same run.
std::string other_facts(const RunFacts& own, const RunFacts& of_page) {
    std::string html;
    for (const auto& fact : own) {
        if (std::find(of_page.begin(), of_page.end(), fact) != of_page.end()) continue;
        html += fmt::format("{}{} {}", html.empty() ? "" : "; ", escaped(fact.first), escaped(fact.second));
    }
    return html.empty() ? html : paragraph("small", fmt::format("From another run: {}.", html));
}

std::string run_again(const StudyResult& study, bool has_figures) {
    const std::string name = escaped(study.name);
    const bool timed = study.duration_s != 0.0;
    std::string html = fmt::format("<span>{}Run it again: <code>{}</code></span><span>",
                                   timed ? fmt::format("It took {}. ", duration_text(study.duration_s)) : "",
                                   escaped(study.command));
    html += fmt::format("<a href=\"{0}.csv\">CSV</a> &ensp;<a href=\"{0}.json\">JSON</a>", name);
    if (has_figures) html += fmt::format(" &ensp;<a href=\"{}.svg\">SVG</a>", name);
    return paragraph("again", html.append("</span>"));
}

/// Figures side by side. One without anything to draw is a sentence.
std::string figures_html(const std::vector<Figure>& figures) {
    std::string drawn;
    std::string empty;
    for (const Figure& figure : figures) {
        if (has_marks(figure))
            drawn += fmt::format("<figure>{}</figure>\n", to_svg(figure));
        else
            empty += paragraph("small", fmt::format("“{}” is not drawn: it has no point that is finite.",
                                                    escaped(figure.title)));
    }
    if (drawn.empty()) return empty;
    return fmt::format("<div class=\"figures\">\n{}</div>\n{}", drawn, empty);
}

/// The first few stay open, so that a page can be read from top to bottom.
std::string tables_html(const std::vector<Table>& tables) {
    constexpr std::size_t k_open = 3;
    std::string html;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        if (i == k_open)
            html += fmt::format("<details>\n<summary>{} further tables</summary>\n", tables.size() - k_open);
        html += table_block(tables[i]);
    }
    return tables.size() > k_open ? html.append("</details>\n") : html;
}

std::string section(const StudyRun& run, const RunFacts& facts_of_page) {
    const StudyResult& study = run.result;
    const std::vector<Figure> figures = figures_of(study);
    const bool drawn = std::any_of(figures.begin(), figures.end(), has_marks);
    std::string html = fmt::format("<section class=\"study\" id=\"{}\">\n<h2>{}</h2>\n", escaped(study.name),
                                   escaped(study.title));
    if (!study.question.empty()) html += paragraph("question", escaped(study.question));
    if (!study.reference.empty())
        html += paragraph("reference", fmt::format("<b>Reference.</b> {}", escaped(study.reference)));
    if (!study.incomplete.empty())
        html += paragraph("warning",
                          fmt::format("<b>This study is incomplete.</b> {}", escaped(study.incomplete)));
    html.append(other_facts(run.facts, facts_of_page))
        .append(run_again(study, drawn))
        .append(figures_html(figures))
        .append(pictures_html(study));
    for (const SceneGrades& scene : by_scene(study))
        html += grades_block(scene, study.plotted_metric);
    return html.append(tables_html(study.tables)).append("</section>\n");
}

std::string contents(const std::vector<StudyRun>& runs) {
    std::string html = "<nav aria-label=\"Studies\"><h2>Studies</h2>\n<ol>\n";
    for (const StudyRun& run : runs) {
        html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escaped(run.result.name),
                            escaped(run.result.title));
    }
    return html.append("</ol></nav>\n");
}

}  // namespace

std::string to_page(const std::vector<StudyRun>& runs, const RunFacts& facts) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>Rambla "
        "studies</title>\n"
        "<link rel=\"icon\" href=\"data:,\">\n<style>";
    html.append(page_style())
        .append(plot_style())
        .append("</style>\n</head>\n<body>\n<div class=\"page\">\n<header>\n");
    html.append(k_introduction).append(facts_list(facts)).append("</header>\n").append(contents(runs));
    html += "<main>\n";
    if (runs.empty()) html += "<p>No study has been run yet.</p>\n";
    for (const StudyRun& run : runs)
        html += section(run, facts);
    return html.append("</main>\n</div>\n</body>\n</html>\n");
}

}  // namespace rambla::game::study
