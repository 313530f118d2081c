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
    next_clip,
    slower,
    faster,
    quit
};
inline constexpr std::size_t k_actions = static_cast<std::size_t>(Action::quit) + 1;

/// Where an action means something.
enum class ControlScope : std::uint8_t {
    everywhere,
    walking,  ///< where there is somebody to walk
    viewing   ///< where a model is looked at
};

/// An action, its keys (GLFW's codes, 0 for none), and how the help screen calls both.
struct Control {
    Action action;
    ControlScope scope;
    std::array<int, 3> keys;
    std::string_view keys_text;
    std::string_view help;
};

/// In the order of Action; the help screen lists them in this order.
[[nodiscard]] const std::array<Control, k_actions>& controls();

}  // namespace rambla::game
