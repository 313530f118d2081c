#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rambla::game {

/// What a key can ask for.
enum class Action : std::uint8_t {
    forward,
    back,
    left,
    right,
    turn_left,
    turn_right,
    run,
    jump,
    help,
    overlay,
    timings,
    full_screen,
    screenshot,
    pause,
    quit
};
inline constexpr std::size_t k_actions = static_cast<std::size_t>(Action::quit) + 1;

/// An action, its keys (GLFW's codes, 0 for none), and how the help screen calls both. `walking` ones mean
/// nothing where there is nobody to walk.
struct Control {
    Action action;
    bool walking;
    std::array<int, 3> keys;
    std::string_view keys_text;
    std::string_view help;
};

/// In the order of Action; the help screen lists them in this order.
[[nodiscard]] const std::array<Control, k_actions>& controls();

}  // namespace rambla::game
