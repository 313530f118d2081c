#include "game/study/report/order.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace rambla::game::study {
namespace {

/// An interval of one or two values is no wider than their difference, which may be any.
constexpr std::size_t k_least_rounds = 3;

/// One grade's ratio in both runs.
struct Pair {
    std::string grade;
    Spread before;
    Spread now;
};

/// −1 if a is cheaper beyond the spread, 1 if b is, 0 if the intervals overlap.
int order_of(const Spread& a, const Spread& b) {
    return a.high < b.low ? -1 : b.high < a.low ? 1 : 0;
}

/// The grades that both runs have timed, in the new run's order.
std::vector<Pair> pairs_of(const SceneGrades& old_scene, const SceneGrades& new_scene) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < new_scene.grades.size(); ++i) {
        const std::string& name = new_scene.grades[i].grade;
        const auto found = std::find_if(old_scene.grades.begin(), old_scene.grades.end(),
                                        [&](const GradeResult& grade) { return grade.grade == name; });
        if (found == old_scene.grades.end()) continue;
        const auto index = static_cast<std::size_t>(found - old_scene.grades.begin());
        const std::optional<Spread>& before = old_scene.timings[index].ratio;
        const std::optional<Spread>& now = new_scene.timings[i].ratio;
        const bool enough = old_scene.grades[index].ms.size() >= k_least_rounds &&
                            new_scene.grades[i].ms.size() >= k_least_rounds;
        if (enough && before && now) pairs.push_back({name, *before, *now});
    }
    return pairs;
}

/// Two grades that differ by more than their spreads in both runs.
struct Comparison {
    Pair cheaper;  ///< before
    Pair dearer;
    bool reversed = false;
};

std::vector<Comparison> comparisons_of(const std::vector<Pair>& pairs) {
    std::vector<Comparison> comparisons;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (std::size_t j = i + 1; j < pairs.size(); ++j) {
            const int before = order_of(pairs[i].before, pairs[j].before);
            const int now = order_of(pairs[i].now, pairs[j].now);
            if (before == 0 || now == 0) continue;
            const std::size_t cheaper = before < 0 ? i : j;
            comparisons.push_back({pairs[cheaper], pairs[i + j - cheaper], before != now});
        }
    }
    return comparisons;
}

/// Calls `visit` with the name of each scene that both runs have, and its grades.
template <class Visit>
void for_each_scene(const StudyResult& old_run, const StudyResult& new_run, Visit&& visit) {
    const std::vector<SceneGrades> old_scenes = by_scene(old_run);
    for (const SceneGrades& scene : by_scene(new_run)) {
        const auto found =
            std::find_if(old_scenes.begin(), old_scenes.end(),
                         [&](const SceneGrades& old_scene) { return old_scene.scene == scene.scene; });
        if (found != old_scenes.end()) visit(scene.scene, pairs_of(*found, scene));
    }
}

}  // namespace

std::vector<Reversal> same_order(const StudyResult& old_run, const StudyResult& new_run) {
    std::vector<Reversal> reversals;
    for_each_scene(old_run, new_run, [&](const std::string& scene, const std::vector<Pair>& pairs) {
        for (const auto& [cheaper, dearer, reversed] : comparisons_of(pairs))
            if (reversed)
                reversals.push_back({scene, cheaper.grade, dearer.grade, cheaper.before, dearer.before,
                                     cheaper.now, dearer.now});
    });
    return reversals;
}

std::size_t compared_pairs(const StudyResult& old_run, const StudyResult& new_run) {
    std::size_t count = 0;
    for_each_scene(old_run, new_run, [&](const std::string&, const std::vector<Pair>& pairs) {
        count += comparisons_of(pairs).size();
    });
    return count;
}

bool has_enough_rounds(const StudyResult& run) {
    const auto longest = std::max_element(
        run.grades.begin(), run.grades.end(),
        [](const GradeResult& a, const GradeResult& b) { return a.ms.size() < b.ms.size(); });
    return longest != run.grades.end() && longest->ms.size() >= k_least_rounds;
}

std::string to_text(const Reversal& r) {
    return fmt::format(
        "{}: {} was cheaper than {} ({:.2f} against {:.2f}), now it is dearer ({:.2f} against {:.2f})",
        r.scene, r.grade, r.other, r.old_ratio.median, r.old_other_ratio.median, r.new_ratio.median,
        r.new_other_ratio.median);
}

}  // namespace rambla::game::study
