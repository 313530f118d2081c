#include "game/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

namespace rambla::game {
namespace {

using testing::HasSubstr;

enum class Grade { off, coarse, fine };

struct Sample {
    Grade grade = Grade::coarse;
    int taps = 4;
    float distance_m = 10.0f;
    bool soft = false;
};

constexpr std::array<std::string_view, 3> k_grades{"off", "coarse", "fine"};
constexpr std::array k_table{
    parameter<&Sample::grade>("grade", k_grades, "How well."),
    parameter<&Sample::taps>("taps", "", 1, 16, "How often."),
    parameter<&Sample::distance_m>("distance", "m", 0.5, 100, "How far."),
    parameter<&Sample::soft>("soft", "", 0, 1, "Whether soft."),
};

struct Parameters : testing::Test {
    Sample sample;
    std::vector<BoundParameter> bound = bind(k_table, sample);

    std::string complaint(std::string_view text) {
        try {
            set_from_method_text(bound, text);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(Parameters, AChoiceAndFieldsAreSet) {
    set_from_method_text(bound, "fine:taps=16,distance=2.5,soft=on");
    EXPECT_EQ(sample.grade, Grade::fine);
    EXPECT_EQ(sample.taps, 16);
    EXPECT_EQ(sample.distance_m, 2.5f);
    EXPECT_TRUE(sample.soft);
}

TEST_F(Parameters, AChoiceAloneLeavesTheFieldsAlone) {
    set_from_method_text(bound, "off");
    EXPECT_EQ(sample.grade, Grade::off);
    EXPECT_EQ(sample.taps, 4);
}

TEST_F(Parameters, FieldsAloneLeaveTheChoiceAlone) {
    set_from_method_text(bound, "taps=1,distance=1e1");
    EXPECT_EQ(sample.grade, Grade::coarse);
    EXPECT_EQ(sample.taps, 1);
    EXPECT_EQ(sample.distance_m, 10.0f);
}

TEST_F(Parameters, BothEndsOfARangeAreInIt) {
    set_from_method_text(bound, "taps=1,distance=0.5");
    EXPECT_EQ(sample.distance_m, 0.5f);
    set_from_method_text(bound, "taps=16,distance=100");
    EXPECT_EQ(sample.distance_m, 100.0f);
}

TEST_F(Parameters, AValueOutOfRangeIsNamedWithTheRange) {
    EXPECT_EQ(complaint("fine:taps=17"), "taps is '17', expected a whole number from 1 to 16");
    EXPECT_EQ(complaint("fine:distance=0.4"), "distance is '0.4', expected 0.5 to 100 m");
}

TEST_F(Parameters, WhatIsNoNumberIsRefused) {
    for (const char* const text : {"", "taps=", "taps=four", "taps=4x", "taps=2.5", "taps= 4", "distance=nan",
                                   "distance=inf", "taps", "soft=maybe", ":", "fine:,", "fine:taps"}) {
        EXPECT_NE(complaint(text), "") << text;
    }
}

TEST_F(Parameters, AnUnknownChoiceListsTheKnownOnes) {
    EXPECT_EQ(complaint("finest"), "grade is 'finest', expected one of: off, coarse, fine");
}

TEST_F(Parameters, AnUnknownNameListsTheKnownOnes) {
    const std::string text = complaint("fine:tap=4");
    EXPECT_THAT(text, HasSubstr("'tap'"));
    EXPECT_THAT(text, HasSubstr("grade, taps, distance, soft"));
}

TEST_F(Parameters, NothingIsSetWhenAnythingIsWrong) {
    EXPECT_NE(complaint("fine:taps=8,distance=1000"), "");
    EXPECT_EQ(sample.grade, Grade::coarse);
    EXPECT_EQ(sample.taps, 4);
}

TEST_F(Parameters, EveryValuePrintedIsReadBackAsItself) {
    set_from_method_text(bound, "off:taps=7,distance=12.25,soft=on");
    Sample copy;
    const std::vector<BoundParameter> other = bind(k_table, copy);
    for (std::size_t i = 0; i < bound.size(); ++i)
        set_from_text(other[i], value_text(bound[i]));
    EXPECT_EQ(copy.grade, sample.grade);
    EXPECT_EQ(copy.taps, sample.taps);
    EXPECT_EQ(copy.distance_m, sample.distance_m);
    EXPECT_EQ(copy.soft, sample.soft);
}

TEST_F(Parameters, HelpNamesEveryParameterWithRangeAndDefault) {
    const std::string help = help_text(bound);
    EXPECT_THAT(help, HasSubstr("How often. (a whole number from 1 to 16; default 4)"));
    EXPECT_THAT(help, HasSubstr("How far. (0.5 to 100 m; default 10)"));
    EXPECT_THAT(help, HasSubstr("default coarse"));
    EXPECT_THAT(help, HasSubstr("on or off; default off"));
}

}  // namespace
}  // namespace rambla::game
