#include "game/study/report/csv.h"

#include <spdlog/fmt/fmt.h>

#include "game/study/report/text.h"
#include "game/study/report/timing.h"

namespace rambla::game::study {
namespace {

std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted.append(c == '"' ? 2 : 1, c);
    return quoted.append("\"");
}

std::string median_cell(const std::optional<Spread>& spread) {
    return spread ? exact(spread->median) : std::string{};
}

}  // namespace

std::string to_csv(const StudyResult& result) {
    std::string text = "study,scene,grade,metric,value,unit,ms,ms_ratio,bytes\n";
    for (const SceneGrades& scene : by_scene(result)) {
        for (std::size_t i = 0; i < scene.grades.size(); ++i) {
            const GradeResult& grade = scene.grades[i];
            const std::string who =
                fmt::format("{},{},{}", cell(result.name), cell(grade.scene), cell(grade.grade));
            const std::string cost = fmt::format("{},{},{}", median_cell(scene.timings[i].ms),
                                                 median_cell(scene.timings[i].ratio), exact(grade.bytes));
            for (const Metric& metric : grade.metrics) {
                text += fmt::format("{},{},{},{},{}\n", who, cell(metric.name), exact(metric.value),
                                    cell(metric.unit), cost);
            }
            if (grade.metrics.empty()) text += fmt::format("{},,,,{}\n", who, cost);
        }
    }
    return text;
}

}  // namespace rambla::game::study
