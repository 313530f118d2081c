#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "assets/environment.h"

namespace rambla::assets {

/// A moment of the one day that generated places know: 5 June at 41.4° N, Barcelona's latitude, in true solar
/// time, so that the sun is highest at 12:00.
struct TimeOfDay {
    /// Minutes after midnight, 0 … 1439. None: the standard noon of noon() and of each place's own walk,
    /// whose sun stands where it draws good shadows instead of where astronomy has it.
    std::optional<int> solar_minutes;

    bool operator==(const TimeOfDay&) const = default;
};

/// The blue hour: the sun stands 4.6° below the horizon.
inline constexpr TimeOfDay k_dusk{19 * 60 + 55};
/// The last twilight is gone, and many people are still up.
inline constexpr TimeOfDay k_night{22 * 60};

/// `noon`, or HH:MM.
[[nodiscard]] std::string to_text(TimeOfDay time);

/// What to_text() writes; nothing for other text.
[[nodiscard]] std::optional<TimeOfDay> time_from_text(std::string_view text);

/// Sine of the sun's height above the horizon, in [-1, 1]. Refraction, which lifts it by up to half a degree,
/// is left out.
[[nodiscard]] float sun_height_sine(TimeOfDay time);

/// Clear sky at that time. East is +X, south +Z. The sun's light fades out while its disc sinks through the
/// horizon, and is zero from 0.833° below it on. By day proportions are nature's. Twilight and night are not:
/// in noon's units a moonless sky is a hundred-millionth, here it is as bright beside lamps and walls as
/// photographs of towns show it.
[[nodiscard]] Environment daylight(TimeOfDay time);

/// The exposure, in EV, at which a picture of that time looks as photographs of such times do: 0 by day.
[[nodiscard]] float daylight_exposure_ev(TimeOfDay time);

}  // namespace rambla::assets
