#include "game/study/report/figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace rambla::game::study {
namespace {

using testing::ElementsAre;

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

TEST(StudyFigure, TheParetoFrontHoldsWhatNothingBeats) {
    EXPECT_THAT(on_pareto_front({{1, 5}, {2, 3}, {3, 4}, {4, 1}, {4, 2}, {2, 6}}),
                ElementsAre(true, true, false, true, false, false));
    EXPECT_THAT(on_pareto_front({}), ElementsAre());
}

TEST(StudyFigure, EqualPointsAreOnTheFrontTogether) {
    EXPECT_THAT(on_pareto_front({{1, 1}, {1, 1}, {2, 1}, {1, 2}}), ElementsAre(true, true, false, false));
}

TEST(StudyFigure, PointsThatAreNotFiniteAreNotOnTheFront) {
    EXPECT_THAT(
        on_pareto_front({{k_nan, 0}, {0, k_nan}, {1, 1}, {-std::numeric_limits<double>::infinity(), 0}}),
        ElementsAre(false, false, true, false));
}

TEST(StudyFigure, MoreDecibelsAreBetter) {
    EXPECT_TRUE(higher_is_better("psnr_db"));
    EXPECT_FALSE(higher_is_better("flip_mean"));
    EXPECT_THAT(on_pareto_front({{1, 30}, {2, 40}, {3, 35}}, true), ElementsAre(true, true, false));
}

GradeResult grade(std::string scene, std::string name, std::vector<double> ms, double error) {
    return {std::move(scene), std::move(name), std::move(ms), 0, {{"flip_mean", error, ""}}};
}

StudyResult sample() {
    StudyResult study;
    study.plotted_metric = "flip_mean";
    study.grades = {grade("street", "queried:eta=1", {1, 2, 3}, 0.1),
                    grade("street", "simple", {1, 1, 1}, 0.2), grade("plaza", "simple", {4}, 0.3),
                    grade("street", "queried:eta=2", {5, 5, 5}, 0.0)};
    return study;
}

TEST(StudyFigure, ErrorsAreDrawnAgainstMillisecondsForEachScene) {
    const std::vector<Figure> figures = error_figures(sample());
    ASSERT_EQ(figures.size(), 2u);
    EXPECT_EQ(figures[0].title, "street");
    ASSERT_EQ(figures[0].series.size(), 2u);
    EXPECT_EQ(figures[0].series[0].name, "queried");
    const Mark& mark = figures[0].series[0].marks[0];
    EXPECT_EQ(mark.at, glm::dvec2(2.0, 0.1));
    EXPECT_DOUBLE_EQ(mark.x_low, 1.2);
    EXPECT_DOUBLE_EQ(mark.x_high, 2.8);
    EXPECT_EQ(mark.label, "queried:eta=1");
    // Its place among the scene's grades, which is its row in the table.
    EXPECT_EQ(figures[0].series[0].marks[1].number, 3u);
    EXPECT_TRUE(figures[0].pareto);
}

TEST(StudyFigure, GradesWithoutTheMetricOrATimeAreLeftOut) {
    StudyResult study = sample();
    study.grades[0].metrics[0].name = "other";
    study.grades[2].ms.clear();
    const std::vector<Figure> figures = error_figures(study);
    ASSERT_EQ(figures.size(), 1u);
    EXPECT_EQ(figures[0].series[0].name, "simple");
    study.plotted_metric.clear();
    EXPECT_TRUE(error_figures(study).empty());
}

TEST(StudyFigure, AxesAreLogarithmicWhereValuesSpreadFar) {
    StudyResult study = sample();
    EXPECT_FALSE(error_figures(study)[0].x_log);
    study.grades[1].ms = {0.01, 0.01};
    study.grades[1].metrics[0].value = 90.0;
    EXPECT_TRUE(error_figures(study)[0].x_log);
    EXPECT_TRUE(error_figures(study)[0].y_log);
    study.grades[3].metrics[0].value = -0.1;
    EXPECT_FALSE(error_figures(study)[0].y_log);
}

}  // namespace
}  // namespace rambla::game::study
