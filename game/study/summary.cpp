#include "game/study/summary.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "game/pass_table.h"
#include "game/study/report/text.h"
#include "game/study/report/timing.h"

namespace rambla::game::study {
namespace {

std::string spread_text(const std::optional<Spread>& spread) {
    if (!spread) return fmt::format("{:>9} {:>19}", "-", "");
    return fmt::format("{:>9.2f} {:>19}", spread->median,
                       fmt::format("{:.2f} .. {:.2f}", spread->low, spread->high));
}

std::string head(const SceneGrades& scene, std::size_t width) {
    std::string text = fmt::format("{}\n{:<{}}{:>9} {:>19}{:>9}{:>12}", scene.scene, "  grade", width, "ms",
                                   "10 .. 90 %", "ratio", "bytes");
    for (const Metric& metric : scene.grades.front().metrics)
        text += fmt::format("  {}", metric.name);
    return text + "\n";
}

std::string line(const GradeResult& grade, const Timing& timing, std::size_t width) {
    std::string text = fmt::format("  {:<{}}", grade.grade, width - 2);
    text += spread_text(timing.ms);
    text += timing.ratio ? fmt::format("{:>9.2f}", timing.ratio->median) : fmt::format("{:>9}", "-");
    text += fmt::format("{:>12}", bytes_text(grade.bytes));
    for (const Metric& metric : grade.metrics)
        text += fmt::format("  {:>{}}", brief(metric.value), metric.name.size());
    return text + "\n";
}

}  // namespace

std::string to_text(const StudyResult& result) {
    std::string text = fmt::format("{}: {:.1f} s\n", result.title, result.duration_s);
    if (!result.incomplete.empty()) text += fmt::format("INCOMPLETE: {}\n", result.incomplete);
    for (const SceneGrades& scene : by_scene(result)) {
        std::size_t width = 0;
        for (const GradeResult& grade : scene.grades)
            width = std::max(width, grade.grade.size() + 4);
        text.append("\n").append(head(scene, width));
        for (std::size_t i = 0; i < scene.grades.size(); ++i)
            text += line(scene.grades[i], scene.timings[i], width);
    }
    return text.append("\n");
}

}  // namespace rambla::game::study
