#include "game/study/report/timing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rambla::game::study {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

GradeResult grade(std::string name, std::vector<double> ms) {
    return {"scene", std::move(name), std::move(ms)};
}

TEST(StudyTiming, StatesMedianAndPercentilesOfTheRounds) {
    const std::vector<GradeResult> grades{grade("a", {5, 1, 2, 3, 4, 6, 7, 8, 9, 10, 11})};
    const std::vector<Timing> result = timings(grades);
    // 11 values: the 10 % percentile is the second smallest, without interpolation.
    EXPECT_EQ(result[0].ms->median, 6.0);
    EXPECT_EQ(result[0].ms->low, 2.0);
    EXPECT_EQ(result[0].ms->high, 10.0);
}

TEST(StudyTiming, ARatioIsTakenWithinEachRound) {
    // The machine slows down fourfold halfway. b always takes twice as long as a, which the medians would not
    // say: the middle one of a's is 2, of b's it is 4, but with the rounds {1, 2, 9} and {2, 4, 18} mixed up
    // it is not.
    const std::vector<GradeResult> grades{grade("a", {1, 2, 9}), grade("b", {2, 4, 18}),
                                          grade("c", {3, 2, 9})};
    const std::vector<Timing> result = timings(grades);
    EXPECT_TRUE(result[0].cheapest);
    EXPECT_FALSE(result[1].cheapest);
    EXPECT_EQ(result[1].ratio->median, 2.0);
    EXPECT_EQ(result[1].ratio->low, 2.0);
    EXPECT_EQ(result[1].ratio->high, 2.0);
    // Ratio of the medians 3 / 2, but in most rounds c takes as long as a.
    EXPECT_EQ(result[2].ratio->median, 1.0);
}

TEST(StudyTiming, TheCheapestGradeIsOneWithoutSpread) {
    const std::vector<Timing> result =
        timings(std::vector{grade("a", {3, 4}), grade("b", {1, 9}), grade("c", {1, 2})});
    EXPECT_TRUE(result[2].cheapest);
    EXPECT_EQ(result[2].ratio->low, 1.0);
    EXPECT_EQ(result[2].ratio->high, 1.0);
}

TEST(StudyTiming, GradesWithoutRoundsHaveNoTime) {
    const std::vector<Timing> result = timings(std::vector{grade("a", {}), grade("b", {2})});
    EXPECT_FALSE(result[0].ms);
    EXPECT_FALSE(result[0].ratio);
    EXPECT_TRUE(result[1].cheapest);
    EXPECT_TRUE(timings({}).empty());
    EXPECT_FALSE(timings(std::vector{grade("a", {})})[0].cheapest);
}

TEST(StudyTiming, RoundsThatOnlyOneGradeHasAreLeftOutOfTheRatio) {
    const std::vector<Timing> result =
        timings(std::vector{grade("a", {1, 1, 1}), grade("b", {3, 3, 3, 900, 900, 900, 900})});
    EXPECT_EQ(result[1].ratio->high, 3.0);
}

TEST(StudyTiming, WhatIsNoTimeDoesNotCountAndKeepsItsRound) {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::vector<Timing> result = timings(std::vector{
        grade("a", {k_nan, 1, 2, -5, infinite}), grade("b", {7, 3, 6, 7, 7}), grade("c", {k_nan, k_nan})});
    EXPECT_EQ(result[0].ms->median, 1.5);
    EXPECT_EQ(result[1].ratio->low, 3.0);
    EXPECT_EQ(result[1].ratio->high, 3.0);
    EXPECT_FALSE(result[2].ms);
    EXPECT_FALSE(result[2].ratio);
}

TEST(StudyTiming, NothingIsDividedByZero) {
    const std::vector<Timing> result =
        timings(std::vector{grade("a", {0, 0, 0}), grade("b", {1, 2, 3}), grade("c", {0, 0, 0})});
    EXPECT_TRUE(result[0].cheapest);
    EXPECT_EQ(result[0].ratio->median, 1.0);
    EXPECT_FALSE(result[1].ratio);
    EXPECT_FALSE(result[2].ratio);
}

TEST(StudyTiming, GradesAreSortedIntoScenesInTheirOrder) {
    StudyResult study;
    study.grades = {{"x", "a", {4}}, {"y", "a", {1}}, {"x", "b", {2}}};
    const std::vector<SceneGrades> scenes = by_scene(study);
    ASSERT_EQ(scenes.size(), 2u);
    EXPECT_EQ(scenes[0].scene, "x");
    ASSERT_EQ(scenes[0].grades.size(), 2u);
    // The cheapest of its own scene, although the other scene has a cheaper one.
    EXPECT_TRUE(scenes[0].timings[1].cheapest);
    EXPECT_EQ(scenes[0].timings[0].ratio->median, 2.0);
}

}  // namespace
}  // namespace rambla::game::study
