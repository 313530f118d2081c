#include "game/study/report/timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "game/statistics.h"

namespace rambla::game::study {
namespace {

bool is_time(double ms) {
    return std::isfinite(ms) && ms >= 0.0;
}

/// What is no time becomes NaN, so that a round keeps its index.
std::vector<double> times_of(const GradeResult& grade) {
    std::vector<double> times = grade.ms;
    for (double& ms : times)
        if (!is_time(ms)) ms = std::numeric_limits<double>::quiet_NaN();
    return times;
}

std::optional<Spread> ratio_to(const GradeResult& cheapest, const GradeResult& grade) {
    std::vector<double> ratios;
    const std::size_t rounds = std::min(cheapest.ms.size(), grade.ms.size());
    for (std::size_t i = 0; i < rounds; ++i) {
        if (is_time(grade.ms[i]) && is_time(cheapest.ms[i]) && cheapest.ms[i] > 0.0)
            ratios.push_back(grade.ms[i] / cheapest.ms[i]);
    }
    return spread_of(ratios);
}

/// The index of the lowest median; the number of timings without any.
std::size_t cheapest_of(const std::vector<Timing>& timings) {
    std::size_t best = timings.size();
    for (std::size_t i = 0; i < timings.size(); ++i) {
        if (!timings[i].ms) continue;
        if (best == timings.size() || timings[i].ms->median < timings[best].ms->median) best = i;
    }
    return best;
}

}  // namespace

std::optional<Spread> spread_of(std::span<const double> values) {
    std::vector<double> finite;
    for (const double value : values)
        if (std::isfinite(value)) finite.push_back(value);
    if (finite.empty()) return std::nullopt;
    return Spread{percentile(finite, 0.5), percentile(finite, 0.1), percentile(finite, 0.9)};
}

std::vector<Timing> timings(std::span<const GradeResult> grades) {
    std::vector<Timing> result(grades.size());
    for (std::size_t i = 0; i < grades.size(); ++i)
        result[i].ms = spread_of(times_of(grades[i]));
    const std::size_t cheapest = cheapest_of(result);
    if (cheapest == result.size()) return result;
    result[cheapest].cheapest = true;
    for (std::size_t i = 0; i < grades.size(); ++i)
        result[i].ratio = i == cheapest ? Spread{1.0, 1.0, 1.0} : ratio_to(grades[cheapest], grades[i]);
    return result;
}

std::vector<SceneGrades> by_scene(const StudyResult& result) {
    std::vector<SceneGrades> scenes;
    for (const GradeResult& grade : result.grades) {
        auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const SceneGrades& scene) { return scene.scene == grade.scene; });
        if (found == scenes.end()) found = scenes.insert(scenes.end(), {grade.scene, {}, {}});
        found->grades.push_back(grade);
    }
    for (SceneGrades& scene : scenes)
        scene.timings = timings(scene.grades);
    return scenes;
}

const Metric* find_metric(const GradeResult& grade, const std::string& name) {
    for (const Metric& metric : grade.metrics)
        if (metric.name == name) return &metric;
    return nullptr;
}

}  // namespace rambla::game::study
