#include "game/step_clock.h"

#include <algorithm>
#include <cmath>

namespace rambla::game {

std::uint32_t StepClock::advance(double elapsed_s) {
    left_s_ += std::clamp(elapsed_s, 0.0, k_longest_picture_s);
    const double steps = std::floor(left_s_ / systems::k_step_s);
    left_s_ = std::max(0.0, left_s_ - steps * systems::k_step_s);
    return static_cast<std::uint32_t>(steps);
}

StepsAt steps_at(double time_s) {
    // Times that are meant to be whole steps must not become one step more by the last bit of a division.
    constexpr double k_rounding_steps = 1e-6;
    const double exact = std::max(0.0, time_s / systems::k_step_s);
    const double steps = std::ceil(exact - k_rounding_steps);
    return {.steps = static_cast<std::uint64_t>(steps),
            .interpolation = static_cast<float>(std::clamp(1.0 - (steps - exact), 0.0, 1.0))};
}

}  // namespace rambla::game
