#include "assets/daylight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rambla::assets::test {
namespace {

constexpr int k_day = 24 * 60;

Environment at(int minutes) {
    return daylight({minutes});
}

float luminance(glm::vec3 c) {
    return glm::dot(c, glm::vec3{0.2126f, 0.7152f, 0.0722f});
}

float largest(glm::vec3 v) {
    return std::max({v.x, v.y, v.z});
}

TEST(Daylight, NoonIsNoon) {
    EXPECT_EQ(daylight({}).direction_to_sun, noon().direction_to_sun);
    EXPECT_EQ(daylight({}).sun_illuminance, noon().sun_illuminance);
    EXPECT_EQ(daylight({}).ground_radiance, noon().ground_radiance);
    EXPECT_EQ(daylight_exposure_ev({}), 0.0f);
}

TEST(Daylight, TheSunStandsWhereAstronomyHasIt) {
    // 90° − 41.4° + 22.5° in the south at 12:00; as far below in the north at midnight: 90° − 41.4° − 22.5°.
    EXPECT_NEAR(glm::distance(at(720).direction_to_sun,
                              glm::vec3(0.0, std::sin(glm::radians(71.1)), std::cos(glm::radians(71.1)))),
                0.0, 1e-6);
    EXPECT_NEAR(sun_height_sine({0}), -std::sin(glm::radians(26.1)), 1e-6);
    // Half a day is 12/π·acos(−tan φ tan δ) hours: 7 h 25.7 min. It rises in the east, and sets in the west.
    const double half_day =
        720.0 / glm::radians(180.0) * std::acos(-std::tan(glm::radians(41.4)) * std::tan(glm::radians(22.5)));
    EXPECT_GT(sun_height_sine({static_cast<int>(std::ceil(720.0 - half_day))}), 0.0f);
    EXPECT_LT(sun_height_sine({static_cast<int>(std::floor(720.0 - half_day))}), 0.0f);
    EXPECT_GT(at(6 * 60).direction_to_sun.x, 0.9f);
    EXPECT_LT(at(18 * 60).direction_to_sun.x, -0.9f);
}

TEST(Daylight, IsFiniteAndOfUnitDirectionAllDay) {
    for (int m = 0; m < k_day; ++m) {
        const Environment e = at(m);
        EXPECT_NEAR(glm::length(e.direction_to_sun), 1.0f, 1e-6f) << m;
        for (const glm::vec3 v :
             {e.sun_illuminance, e.sky_zenith_radiance, e.sky_horizon_radiance, e.ground_radiance}) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(std::isfinite(v[c])) << m;
                ASSERT_GE(v[c], 0.0f) << m;
                ASSERT_LT(v[c], 4.0f) << m;
            }
        }
        EXPECT_GT(e.sky_zenith_radiance.z, 0.0f) << "nights are not black";
        EXPECT_LE(e.sky_zenith_radiance.x, e.sky_zenith_radiance.z) << "the zenith is blue at " << m;
    }
}

TEST(Daylight, JumpsNowhere) {
    for (int m = 0; m < k_day; ++m) {
        const Environment a = at(m);
        const Environment b = at((m + 1) % k_day);
        // The sun climbs by at most 0.19° a minute, and gains at most 0.2 of illuminance per degree.
        EXPECT_LT(largest(glm::abs(a.sun_illuminance - b.sun_illuminance)), 0.04f) << m;
        // The steepest twilight changes by a factor of 4.7 in 4°, thus by a fourteenth in a minute.
        EXPECT_LT(largest(glm::abs(glm::log(a.sky_zenith_radiance / b.sky_zenith_radiance))), 0.1f) << m;
        EXPECT_LT(largest(glm::abs(glm::log(a.sky_horizon_radiance / b.sky_horizon_radiance))), 0.1f) << m;
        EXPECT_LT(largest(glm::abs(glm::log(a.ground_radiance / b.ground_radiance))), 0.1f) << m;
        EXPECT_LT(std::abs(daylight_exposure_ev({m}) - daylight_exposure_ev({(m + 1) % k_day})), 0.06f) << m;
        EXPECT_LT(glm::distance(a.direction_to_sun, b.direction_to_sun), 0.0045f)
            << "a minute is 0.25° at most";
    }
}

TEST(Daylight, GrowsUntilTwelveAndWanesAfterwards) {
    for (int m = 0; m + 1 <= 720; ++m) {
        const Environment a = at(m);
        const Environment b = at(m + 1);
        // Where nothing changes, the last bit may.
        constexpr float k_rounding = 1.0f - 1e-5f;
        EXPECT_GE(luminance(b.sun_illuminance), k_rounding * luminance(a.sun_illuminance)) << m;
        EXPECT_GE(luminance(b.sky_zenith_radiance), k_rounding * luminance(a.sky_zenith_radiance)) << m;
        EXPECT_GE(luminance(b.sky_horizon_radiance), k_rounding * luminance(a.sky_horizon_radiance)) << m;
        EXPECT_GE(luminance(b.ground_radiance), k_rounding * luminance(a.ground_radiance)) << m;
        EXPECT_LE(daylight_exposure_ev({m + 1}), daylight_exposure_ev({m}) + 1e-5f) << m;
    }
    for (const int m : {30, 300, 400, 700}) {
        EXPECT_NEAR(glm::distance(at(720 - m).sun_illuminance, at(720 + m).sun_illuminance), 0.0f, 1e-5f)
            << "evenings mirror mornings";
    }
}

TEST(Daylight, ASunBelowTheHorizonGivesNoLight) {
    int dark = 0;
    for (int m = 0; m < k_day; ++m) {
        // The usual sunset: the centre 0.833° below.
        if (sun_height_sine({m}) > std::sin(glm::radians(-0.833f))) continue;
        ++dark;
        EXPECT_EQ(at(m).sun_illuminance, glm::vec3{0.0f}) << m;
    }
    EXPECT_GT(dark, 8 * 60);
    EXPECT_EQ(daylight(k_dusk).sun_illuminance, glm::vec3{0.0f});
    EXPECT_EQ(daylight(k_night).sun_illuminance, glm::vec3{0.0f});
}

TEST(Daylight, TheLowSunIsRedAndTheHighOneIsNoons) {
    const auto red_share = [](glm::vec3 c) {
        return c.x / (c.x + c.y + c.z);
    };
    EXPECT_GT(red_share(at(19 * 60 + 5).sun_illuminance), 0.5f);
    EXPECT_LT(red_share(at(720).sun_illuminance), 0.38f);
    // At the height of noon()'s sun, the light is noon()'s. It passes that height between two minutes.
    const float height = noon().direction_to_sun.y;
    int m = 0;
    while (sun_height_sine({m}) < height)
        ++m;
    EXPECT_NEAR(glm::distance(at(m).sun_illuminance, noon().sun_illuminance), 0.0f, 0.01f);
    EXPECT_NEAR(glm::distance(at(m).ground_radiance, noon().ground_radiance), 0.0f, 0.002f);
}

TEST(TimeOfDayText, IsNoonOrAClocks) {
    EXPECT_EQ(to_text({}), "noon");
    EXPECT_EQ(to_text({7 * 60 + 5}), "07:05");
    EXPECT_EQ(to_text({0}), "00:00");
    EXPECT_EQ(to_text({1439}), "23:59");
}

TEST(Daylight, TimesAreReadAsTheyAreWritten) {
    for (int minute = 0; minute < 24 * 60; ++minute)
        EXPECT_EQ(time_from_text(to_text(TimeOfDay{minute})), TimeOfDay{minute});
    EXPECT_EQ(time_from_text(to_text({})), TimeOfDay{});
    for (const char* const other :
         {"", "24:00", "12:60", "1:00", "12-30", "ab:cd", "noon ", "12:000", "-1:00"})
        EXPECT_FALSE(time_from_text(other)) << other;
}

}  // namespace
}  // namespace rambla::assets::test
