#include "game/time_of_day.h"

#include <spdlog/fmt/fmt.h>

#include <optional>
#include <stdexcept>

namespace rambla::game {

assets::TimeOfDay parse_time(const std::string& text) {
    if (text == "dusk") return assets::k_dusk;
    if (text == "night") return assets::k_night;
    if (const std::optional<assets::TimeOfDay> time = assets::time_from_text(text)) return *time;
    throw std::invalid_argument{
        fmt::format("time is '{}', expected noon, dusk, night or HH:MM from 00:00 to 23:59", text)};
}

}  // namespace rambla::game
