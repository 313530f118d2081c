#pragma once

#include <stdexcept>

namespace rambla::game {

/// What the program ends with.
inline constexpr int k_done = 0;
inline constexpr int k_check_failed = 1;
inline constexpr int k_bad_input = 2;      ///< wrong usage, or a file that cannot be used
inline constexpr int k_machine_lacks = 3;  ///< no display, or no context that can draw

/// This machine cannot do what was asked; the message says what is missing and what helps.
struct MachineLacks : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace rambla::game
