#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "game/study/report/timing.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// Two grades of a scene that changed places.
struct Reversal {
    std::string scene;
    std::string grade;  ///< the cheaper one before, the dearer one now
    std::string other;
    Spread old_ratio, old_other_ratio;  ///< to the cheapest grade of their scene
    Spread new_ratio, new_other_ratio;
};

/// The pairs of grades of one scene whose order of cost is another in two runs of a study, although in each
/// run they differ by more than the spread that is printed: the 10–90 % intervals of their ratios to the
/// cheapest grade do not overlap. Grades and scenes that only one of the runs has say nothing.
[[nodiscard]] std::vector<Reversal> same_order(const StudyResult& old_run, const StudyResult& new_run);

/// How many pairs of grades of one scene differ by more than the printed spread in both runs: all that
/// same_order() can say something about. Grades of fewer than three rounds have no spread worth the name.
[[nodiscard]] std::size_t compared_pairs(const StudyResult& old_run, const StudyResult& new_run);

/// Whether any grade of a run has the rounds that a comparison takes, which are three.
[[nodiscard]] bool has_enough_rounds(const StudyResult& run);

/// "blocks: a was cheaper than b (1.00 against 1.52), now it is dearer (1.41 against 1.00)"
[[nodiscard]] std::string to_text(const Reversal& reversal);

}  // namespace rambla::game::study
