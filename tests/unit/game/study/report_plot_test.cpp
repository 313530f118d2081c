#include "game/study/report/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "game/study/report/text.h"
#include "unit/game/study/svg_reader.h"

namespace rambla::game::study {
namespace {

using testing::HasSubstr;

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinite = std::numeric_limits<double>::infinity();

Plot plot_of(std::vector<glm::dvec2> points) {
    return {"Title", "x", "y", false, false, false, {{"series", std::move(points)}}};
}

/// Reads a figure after checking what holds for all: it is XML, all marks lie inside the axes and all texts,
/// as wide as they are thought to be at most, inside the picture.
SvgFigure drawn(const Figure& figure) {
    const std::string svg = to_svg(figure);
    EXPECT_TRUE(is_well_formed(svg)) << svg;
    EXPECT_THAT(svg, testing::Not(testing::AnyOf(HasSubstr("nan"), HasSubstr("inf"), HasSubstr("e+"))));
    const SvgFigure read = read_svg(svg);
    for (const glm::dvec2& mark : read.marks) {
        EXPECT_GE(mark.x, read.frame.low.x);
        EXPECT_LE(mark.x, read.frame.high.x);
        EXPECT_GE(mark.y, read.frame.low.y);
        EXPECT_LE(mark.y, read.frame.high.y);
    }
    for (const SvgText& text : read.texts) {
        // Narrow characters of DejaVu Sans, the widest of the fonts in use, are below this on average.
        const double width = static_cast<double>(length(text.text)) * 6.0;
        const double left = text.at.x - (text.anchor == "end"      ? width
                                         : text.anchor == "middle" ? width / 2
                                                                   : 0.0);
        if (text.text.find('&') != std::string::npos) continue;
        EXPECT_GE(left, -1.0) << text.text;
        EXPECT_LE(left + width, read.size.x + 1.0) << text.text;
        EXPECT_LE(text.at.y, read.size.y) << text.text;
    }
    return read;
}

SvgFigure drawn(const Plot& plot) {
    return drawn(to_figure(plot));
}

TEST(StudyPlot, PointsLieWhereTheirValuesSay) {
    const SvgFigure figure = drawn(plot_of({{0, 0}, {10, 100}, {5, 50}}));
    ASSERT_EQ(figure.marks.size(), 3u);
    // Halfway between the other two, to the hundredth to which coordinates are written.
    EXPECT_NEAR(figure.marks[2].x, (figure.marks[0].x + figure.marks[1].x) / 2, 0.02);
    EXPECT_NEAR(figure.marks[2].y, (figure.marks[0].y + figure.marks[1].y) / 2, 0.02);
    EXPECT_LT(figure.marks[1].y, figure.marks[0].y);  // upwards
    EXPECT_NEAR(figure.marks[0].x, figure.frame.low.x, 0.01);
    EXPECT_NEAR(figure.marks[0].y, figure.frame.high.y, 0.01);
}

TEST(StudyPlot, LogarithmsSpaceDecadesEvenly) {
    Plot plot = plot_of({{1, 0.01}, {10, 0.1}, {1000, 10}});
    plot.x_log = plot.y_log = true;
    const SvgFigure figure = drawn(plot);
    EXPECT_NEAR((figure.marks[2].x - figure.marks[1].x) / (figure.marks[1].x - figure.marks[0].x), 2.0, 0.01);
    EXPECT_NEAR((figure.marks[2].y - figure.marks[1].y) / (figure.marks[1].y - figure.marks[0].y), 2.0, 0.01);
}

TEST(StudyPlot, ErrorsThatAreNearlyEqualLookEqual) {
    Figure figure = to_figure(plot_of({{1, 0.0100}, {2, 0.0101}}));
    figure.y_from_zero = true;
    const SvgFigure read = drawn(figure);
    // One percent of the axis, and a little less for the margin above.
    EXPECT_NEAR(read.marks[0].y - read.marks[1].y, 2.2, 0.2);
}

TEST(StudyPlot, WhatIsNotAboveZeroLiesAtTheEndOfALogarithmicAxisAndIsNamed) {
    Plot plot = plot_of({{1, 1}, {0, 10}, {2, -5}});
    plot.x_log = plot.y_log = true;
    const SvgFigure figure = drawn(plot);
    EXPECT_EQ(figure.marks[1].x, figure.frame.low.x);
    EXPECT_EQ(figure.marks[2].y, figure.frame.high.y);
    EXPECT_THAT(figure.texts_of("note"),
                testing::ElementsAre("At the left end, since not above zero: 1 point.",
                                     "At the lower end, since not above zero: 1 point."));
}

TEST(StudyPlot, PointsThatAreNotFiniteAreLeftOutAndCounted) {
    const SvgFigure figure = drawn(plot_of({{1, 1}, {k_nan, 10}, {2, k_infinite}}));
    EXPECT_EQ(figure.marks.size(), 1u);
    EXPECT_THAT(figure.texts_of("note"), testing::ElementsAre("Left out, since not finite: 2 points."));
}

TEST(StudyPlot, NoPointsAreSaidToBeNone) {
    EXPECT_THAT(drawn(plot_of({})).texts_of("note"),
                testing::ElementsAre("Nothing to draw: no point is finite."));
    EXPECT_FALSE(has_marks(to_figure(plot_of({{k_nan, 1}}))));
    EXPECT_TRUE(drawn(Plot{}).marks.empty());
}

TEST(StudyPlot, HardValuesStayInsideTheAxes) {
    const std::vector<std::vector<glm::dvec2>> cases{
        {{3, 4}},
        {{0, 0}},
        {{3, 4}, {3, 4}, {3, 4}},
        {{-1.7e308, 1.7e308}, {1.7e308, -1.7e308}, {0, 0}},
        {{5e-324, 1}, {1.7e308, 5e-324}},
        {{1e15, 1e6}, {1e15 + 1, 1e6 + 1e-6}},
        {{-1, -2}, {0, 0}},
    };
    for (const std::vector<glm::dvec2>& points : cases) {
        for (const int logs : {0, 1, 2, 3}) {
            Plot plot = plot_of(points);
            plot.x_log = (logs & 1) != 0;
            plot.y_log = (logs & 2) != 0;
            plot.pareto = true;
            plot.series[0].line = true;
            EXPECT_EQ(drawn(plot).marks.size(), points.size());
        }
    }
}

TEST(StudyPlot, LongAndUnusualNamesStayInsideThePicture) {
    const std::string longest(300, 'm');
    Plot plot{longest, longest + " <b> & \"c\" \xFF", longest, false, true, true, {}};
    for (int i = 0; i < 9; ++i)
        plot.series.push_back({longest + std::to_string(i), {{i, i + 1}}});
    EXPECT_EQ(drawn(plot).marks.size(), 9u);
}

TEST(StudyPlot, TheFrontIsAStaircaseToTheRight) {
    Plot plot = plot_of({{1, 8}, {4, 2}, {3, 6}, {5, 5}});
    plot.pareto = true;
    const SvgFigure figure = drawn(plot);
    const std::vector<glm::dvec2>& front = figure.fronts.at(0);
    ASSERT_EQ(front.size(), 6u);  // three points, two corners, the end
    EXPECT_EQ(front[0], figure.marks[0]);
    EXPECT_EQ(front[1], glm::dvec2(figure.marks[2].x, figure.marks[0].y));
    EXPECT_EQ(front[2], figure.marks[2]);
    EXPECT_EQ(front[4], figure.marks[1]);
    EXPECT_EQ(front[5], glm::dvec2(figure.frame.high.x, figure.marks[1].y));
    EXPECT_THAT(figure.texts_of("key"), testing::Contains("Pareto front"));
}

TEST(StudyPlot, SeriesDifferInColourAndShape) {
    Plot plot = plot_of({{0, 0}});
    for (int i = 1; i < 20; ++i)
        plot.series.push_back({"another", {{i, i}}});
    const SvgFigure figure = drawn(plot);
    std::set<std::pair<std::string, std::string>> looks;
    for (std::size_t i = 0; i < figure.marks.size(); ++i)
        looks.insert({figure.colours[i], figure.shapes[i]});
    EXPECT_EQ(looks.size(), 20u);
    EXPECT_EQ(std::set<std::string>(figure.shapes.begin(), figure.shapes.end()).size(), 8u);
}

TEST(StudyPlot, TheLegendNamesTheSeries) {
    Plot plot = plot_of({{0, 1}});
    plot.series.push_back({"a & b", {{1, 2}}, true});
    EXPECT_THAT(drawn(plot).texts_of("key"), testing::ElementsAre("series", "a &amp; b"));
}

TEST(StudyPlot, ALineBreaksWhereAPointIsMissing) {
    Plot plot = plot_of({{0, 1}, {1, 2}, {k_nan, 3}, {3, 4}, {4, 5}});
    plot.series[0].line = true;
    EXPECT_EQ(matches(to_svg(to_figure(plot)), "<path class=\"s0 line\" d=\"").size(),
              2u + 1u);  // one in the legend
}

/// Grades of one technique, so near to each other that names would cover each other from some number on.
Figure crowded(std::size_t grades) {
    Figure figure{.title = "scene", .x_label = "milliseconds", .y_label = "error", .pareto = true};
    figure.series.push_back({"queried"});
    for (std::size_t i = 0; i < grades; ++i) {
        const double x = 10.0 + static_cast<double>(i % 7);
        figure.series[0].marks.push_back({{x, 1.0 + static_cast<double>(i)},
                                          x - 0.5,
                                          x + 0.5,
                                          "queried:eta_min=0.00" + std::to_string(i),
                                          i + 1});
    }
    return figure;
}

TEST(StudyPlot, AFewGradesAreNamedAtTheirMarks) {
    const SvgFigure figure = drawn(crowded(3));
    EXPECT_THAT(
        figure.texts_of("name"),
        testing::ElementsAre("queried:eta_min=0.000", "queried:eta_min=0.001", "queried:eta_min=0.002"));
    EXPECT_THAT(figure.texts_of("key"), testing::ElementsAre("Pareto front"));
}

TEST(StudyPlot, ManyGradesAreNumberedAndTheLegendNamesThem) {
    const SvgFigure figure = drawn(crowded(40));
    EXPECT_EQ(figure.texts_of("name").size(), 40u);
    EXPECT_THAT(figure.texts_of("name"), testing::Contains("40"));
    EXPECT_THAT(figure.texts_of("key"), testing::Contains("queried:eta_min=0.0039"));
    // No number stands on another: they are about 7 units wide a digit, and 12 high.
    std::vector<SvgText> numbers;
    for (const SvgText& text : figure.texts)
        if (text.css_class == "name") numbers.push_back(text);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        for (std::size_t j = i + 1; j < numbers.size(); ++j) {
            const glm::dvec2 distance = glm::abs(numbers[i].at - numbers[j].at);
            EXPECT_TRUE(distance.x > 6.0 || distance.y > 8.0)
                << numbers[i].text << " and " << numbers[j].text;
        }
    }
}

TEST(StudyPlot, WhiskersReachFromPercentileToPercentile) {
    Figure figure = crowded(1);
    const std::string svg = to_svg(figure);
    const std::vector<std::smatch> whiskers = matches(svg, R"re(<path class="s0 whisker" d="([^"]*)"/>)re");
    ASSERT_EQ(whiskers.size(), 3u);  // and its two ends
    const std::vector<glm::dvec2> ends = path_points(whiskers[0][1].str());
    const SvgFigure read = drawn(figure);
    EXPECT_NEAR(read.marks[0].x - ends[0].x, ends[1].x - read.marks[0].x, 0.02);
    EXPECT_GE(ends[0].x, read.frame.low.x);
    EXPECT_LE(ends[1].x, read.frame.high.x);
}

TEST(StudyPlot, AFileHoldsAllFiguresAndTheirStyle) {
    const std::string svg = to_svg_file({to_figure(plot_of({{1, 2}})), crowded(2)});
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
    EXPECT_EQ(matches(svg, "<svg class=\"plot\"").size(), 2u);
}

}  // namespace
}  // namespace rambla::game::study
