#include "game/study/report/axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rambla::game::study {
namespace {

constexpr double k_length = 360.0;
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinite = std::numeric_limits<double>::infinity();

Axis axis_of(const std::vector<double>& values, bool log) {
    return make_axis(values, log, k_length, Direction::horizontal);
}

std::vector<std::string> labels_of(const Axis& axis) {
    std::vector<std::string> labels;
    for (const Tick& tick : axis.ticks)
        if (!tick.label.empty()) labels.push_back(tick.label);
    return labels;
}

TEST(StudyAxis, LinearTicksAreSteps) {
    EXPECT_THAT(labels_of(axis_of({0, 9.7}, false)), testing::ElementsAre("0", "2", "4", "6", "8", "10"));
    EXPECT_THAT(labels_of(axis_of({-0.31, 0.52}, false)), testing::ElementsAre("−0.2", "0", "0.2", "0.4"));
}

TEST(StudyAxis, StartsAtZeroWhereValuesComeNear) {
    EXPECT_EQ(axis_of({10, 100}, false).low, 0.0);
    EXPECT_GT(axis_of({90, 100}, false).low, 80.0);
}

TEST(StudyAxis, LogarithmicTicksAreDecadesWithMinorOnesBetween) {
    const Axis axis = axis_of({0.02, 300}, true);
    EXPECT_THAT(labels_of(axis), testing::ElementsAre("0.1", "1", "10", "100"));
    // Seven or eight minor ticks in each whole decade.
    EXPECT_GT(axis.ticks.size(), 30u);
    EXPECT_DOUBLE_EQ(axis.place(1.0) - axis.place(0.1), axis.place(100.0) - axis.place(10.0));
}

TEST(StudyAxis, AShortLogarithmicAxisHasMoreLabels) {
    EXPECT_THAT(labels_of(axis_of({0.9, 60}, true)), testing::ElementsAre("1", "2", "5", "10", "20", "50"));
    EXPECT_GE(labels_of(axis_of({3.0, 3.5}, true)).size(), 3u);
}

TEST(StudyAxis, ALongLogarithmicAxisHasPowersAndLeavesSomeOut) {
    EXPECT_THAT(labels_of(axis_of({1e-9, 1e3}, true)), testing::Contains("10⁻⁶"));
    EXPECT_LE(labels_of(axis_of({1e-300, 1e300}, true)).size(), 7u);
}

TEST(StudyAxis, WhatHasNoLogarithmLiesAtTheLowerEndApartFromTheRest) {
    const Axis axis = axis_of({0, -5, 0.1, 10}, true);
    EXPECT_EQ(labels_of(axis).front(), "≤ 0");
    EXPECT_EQ(axis.place(0.0), 0.0);
    EXPECT_EQ(axis.place(-5.0), 0.0);
    EXPECT_GT(axis.place(0.1), 0.1);
    EXPECT_THAT(labels_of(axis_of({0, -1}, true)), testing::Contains("≤ 0"));
}

/// Whatever the values: they lie on the axis, ticks ascend on it, and there are labels that do not touch.
void expect_sound(const std::vector<double>& values, bool log, Direction direction) {
    SCOPED_TRACE(testing::PrintToString(values) + (log ? " logarithmic" : " linear"));
    const Axis axis = make_axis(values, log, k_length, direction);
    EXPECT_TRUE(std::isfinite(axis.low) && std::isfinite(axis.high));
    EXPECT_LT(axis.low, axis.high);
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        EXPECT_GE(axis.place(value), 0.0);
        EXPECT_LE(axis.place(value), 1.0);
        if (value > 1e-300 || !log) {
            EXPECT_LE(value, axis.high);
        }
    }
    EXPECT_GE(labels_of(axis).size(), 1u);
    EXPECT_LE(labels_of(axis).size(), 12u);
    double last_end = -1e9;
    double last = -1.0;
    for (const Tick& tick : axis.ticks) {
        const double place = axis.place(tick.value);
        EXPECT_GE(place, last);
        last = place;
        if (tick.label.empty() || direction == Direction::vertical) continue;
        const double half = text_width(tick.label) / 2;
        EXPECT_GT(place * k_length - half, last_end) << tick.label;
        last_end = place * k_length + half;
    }
}

TEST(StudyAxis, HardValuesGiveASoundAxis) {
    const std::vector<std::vector<double>> cases{
        {},
        {0},
        {3},
        {-3, -3},
        {k_nan, k_infinite, -k_infinite},
        {1, k_nan, 2},
        {-1.7e308, 1.7e308},
        {0, 1.7e308},
        {5e-324},
        {0, 5e-324},
        {5e-324, 1.7e308},
        {1e15, 1e15 + 1},
        {1e6 + 0.5, 1e6 + 0.9},
        {1, 1 + 1e-15},
        {-1e-320, 1e-320},
        {0.1, 0.1000001},
        {99999, 100001},
    };
    for (const std::vector<double>& values : cases) {
        for (const Direction direction : {Direction::horizontal, Direction::vertical}) {
            expect_sound(values, false, direction);
            expect_sound(values, true, direction);
        }
    }
}

TEST(StudyAxis, RandomValuesGiveASoundAxis) {
    std::mt19937 random{1};
    std::uniform_real_distribution<double> exponent{-300.0, 300.0};
    std::uniform_real_distribution<double> small_exponent{-6.0, 6.0};
    for (int round = 0; round < 300; ++round) {
        std::vector<double> values;
        for (int i = 0; i < 4; ++i) {
            const double size = std::pow(10.0, round % 2 == 0 ? exponent(random) : small_exponent(random));
            values.push_back(round % 3 == 0 && i == 0 ? -size : size);
        }
        expect_sound(values, false, Direction::horizontal);
        expect_sound(values, true, Direction::horizontal);
    }
}

}  // namespace
}  // namespace rambla::game::study
