#include "game/time_of_day.h"

#include <spdlog/fmt/fmt.h>

#include <optional>
#include <stdexcept>

namespace rambla::game {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Minutes after midnight of exactly five characters HH:MM.
std::optional<int> clock_minutes(const std::string& text) {
    if (text.size() != 5 || text[2] != ':') return {};
    for (const std::size_t i : {0u, 1u, 3u, 4u}) {
        if (!is_digit(text[i])) return {};
    }
    const int hours = 10 * (text[0] - '0') + (text[1] - '0');
    const int minutes = 10 * (text[3] - '0') + (text[4] - '0');
    return hours < 24 && minutes < 60 ? std::optional{60 * hours + minutes} : std::nullopt;
}

}  // namespace

assets::TimeOfDay parse_time(const std::string& text) {
    if (text == "noon") return {};
    if (text == "dusk") return assets::k_dusk;
    if (text == "night") return assets::k_night;
    if (const std::optional<int> minutes = clock_minutes(text)) return {minutes};
    throw std::invalid_argument{
        fmt::format("time is '{}', expected noon, dusk, night or HH:MM from 00:00 to 23:59", text)};
}

}  // namespace rambla::game
