#include "game/time_of_day.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <stdexcept>

#include "game/options.h"

namespace rambla::game {
namespace {

TEST(ParseTime, ReadsNamesAndClocks) {
    EXPECT_EQ(parse_time("noon"), assets::TimeOfDay{});
    EXPECT_EQ(parse_time("dusk"), assets::k_dusk);
    EXPECT_EQ(parse_time("night"), assets::k_night);
    EXPECT_EQ(parse_time("00:00"), assets::TimeOfDay{0});
    EXPECT_EQ(parse_time("07:05"), assets::TimeOfDay{425});
    EXPECT_EQ(parse_time("23:59"), assets::TimeOfDay{1439});
}

TEST(ParseTime, RefusesEverythingElse) {
    for (const char* const text : {"", "Noon", "noon ", "7:05", "24:00", "12:60", "12:5", "-1:00", "+1:00",
                                   "12.30", "12:30:00", " 2:30", "1a:00", "12:3x", "midnight"}) {
        try {
            (void)parse_time(text);
            ADD_FAILURE() << text;
        } catch (const std::invalid_argument& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("noon, dusk, night or HH:MM")) << text;
        }
    }
}

TEST(SettingsAt, TakeTheLightsExposureUnlessTheUserHasSaidAnother) {
    CLI::App line{"test"};
    Options options;
    add_picture_options(line, options);
    line.parse("--tonemap filmic");
    EXPECT_EQ(options.settings_at(2.5f).exposure.ev, 2.5f);
    EXPECT_EQ(options.settings_at(2.5f).tone.curve, render::ToneCurve::filmic);
    line.parse("--exposure 0");
    EXPECT_EQ(options.settings_at(2.5f).exposure.ev, 0.0f);
}

}  // namespace
}  // namespace rambla::game
