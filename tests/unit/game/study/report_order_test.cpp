#include "game/study/report/order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rambla::game::study {
namespace {

GradeResult grade(std::string scene, std::string name, std::vector<double> ms) {
    return {std::move(scene), std::move(name), std::move(ms)};
}

StudyResult study(std::vector<GradeResult> grades) {
    StudyResult result;
    result.grades = std::move(grades);
    return result;
}

TEST(StudyOrder, ReportsGradesThatChangedPlaces) {
    const StudyResult before =
        study({grade("s", "a", {1, 1, 1}), grade("s", "b", {2, 2, 2}), grade("s", "c", {3, 3, 3})});
    const StudyResult now =
        study({grade("s", "c", {3, 3, 3}), grade("s", "b", {1, 1, 1}), grade("s", "a", {1.5, 1.5, 1.5})});
    const std::vector<Reversal> reversals = same_order(before, now);
    EXPECT_EQ(compared_pairs(before, now), 3u);
    ASSERT_EQ(reversals.size(), 1u);
    EXPECT_EQ(reversals[0].grade, "a");
    EXPECT_EQ(reversals[0].other, "b");
    EXPECT_EQ(to_text(reversals[0]),
              "s: a was cheaper than b (1.00 against 2.00), now it is dearer (1.50 against 1.00)");
}

TEST(StudyOrder, TwoRoundsAreTooFewToSayAnything) {
    const StudyResult before = study({grade("s", "a", {1, 1}), grade("s", "b", {2, 2})});
    const StudyResult now = study({grade("s", "a", {2, 2}), grade("s", "b", {1, 1})});
    EXPECT_TRUE(same_order(before, now).empty());
    EXPECT_EQ(compared_pairs(before, now), 0u);
    EXPECT_FALSE(has_enough_rounds(before));
    EXPECT_FALSE(has_enough_rounds(study({})));
    EXPECT_TRUE(has_enough_rounds(study({grade("s", "a", {}), grade("s", "b", {1, 1, 1})})));
}

TEST(StudyOrder, TheSameRunHasNoReversal) {
    const StudyResult run =
        study({grade("s", "a", {1, 1.1, 1.2}), grade("s", "b", {3, 2.9, 3.1}), grade("t", "a", {5, 1, 2})});
    EXPECT_TRUE(same_order(run, run).empty());
    EXPECT_EQ(compared_pairs(run, run), 1u) << "the two of one scene, well apart";
}

TEST(StudyOrder, DifferencesWithinTheSpreadOfEitherRunSayNothing) {
    const StudyResult sure = study({grade("s", "a", {1, 1, 1}), grade("s", "b", {2, 2, 2})});
    // b is cheapest, and a takes from 0.5 to 3 times as long.
    const StudyResult unsure = study({grade("s", "a", {0.5, 1.5, 3}), grade("s", "b", {1, 1, 1})});
    EXPECT_TRUE(same_order(sure, unsure).empty());
    EXPECT_TRUE(same_order(unsure, sure).empty());
}

TEST(StudyOrder, GradesOfOtherScenesAndOfOneRunAloneSayNothing) {
    const StudyResult before =
        study({grade("s", "a", {1, 1, 1}), grade("s", "b", {2, 2, 2}), grade("s", "gone", {3, 3, 3})});
    const StudyResult now =
        study({grade("t", "a", {2, 2, 2}), grade("t", "b", {1, 1, 1}), grade("s", "b", {1, 1, 1}),
               grade("s", "new", {2, 2, 2}), grade("s", "a", {})});
    EXPECT_TRUE(same_order(before, now).empty());
    EXPECT_EQ(compared_pairs(before, now), 0u);
    EXPECT_EQ(compared_pairs(before, before), 3u) << "which have rounds enough to be compared";
}

}  // namespace
}  // namespace rambla::game::study
