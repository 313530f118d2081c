#pragma once

#include <string>

#include "assets/daylight.h"

namespace rambla::game {

/// Reads noon, dusk, night or HH:MM. @throws std::invalid_argument  saying what was found and expected
[[nodiscard]] assets::TimeOfDay parse_time(const std::string& text);

}  // namespace rambla::game
