#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/study/result.h"

namespace rambla::game::study {

/// A median and the interval that holds the middle 80 % of the values: their 10 % and 90 % percentiles.
struct Spread {
    double median = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// What the rounds of one grade say.
struct Timing {
    std::optional<Spread> ms;     ///< nothing without a round that holds a time
    std::optional<Spread> ratio;  ///< to the cheapest grade of the scene; nothing without a pair of rounds
    bool cheapest = false;        ///< has the scene's lowest median; the first of equal ones
};

/// Spread of the values that are finite; nothing without one.
[[nodiscard]] std::optional<Spread> spread_of(std::span<const double> values);

/// Timings of the grades of one scene, in their order.
///
/// Rounds are paired: those with one index did the same work one after the other, under the same load of the
/// machine. The ratio is therefore taken within each round and the median over rounds, which a drift of the
/// machine leaves alone; the ratio of the medians would hold it. A round counts if its time is finite and not
/// negative, a pair if the cheapest grade's time is above zero besides; rounds that one grade has and the
/// other has not are left out. The cheapest grade's own ratio is 1 without spread.
[[nodiscard]] std::vector<Timing> timings(std::span<const GradeResult> grades);

/// The grades of one scene, in the study's order.
struct SceneGrades {
    std::string scene;
    std::vector<GradeResult> grades;
    std::vector<Timing> timings;  ///< of the grades
};

/// All grades, sorted into scenes in the order in which these first appear.
[[nodiscard]] std::vector<SceneGrades> by_scene(const StudyResult& result);

/// The metric of this name, or nullptr.
[[nodiscard]] const Metric* find_metric(const GradeResult& grade, const std::string& name);

}  // namespace rambla::game::study
