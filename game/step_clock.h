#pragma once

#include <cstdint>

#include "systems/pipeline.h"

namespace rambla::game {

/// Cuts real time into fixed simulation steps. A picture that takes longer than the limit slows the game down
/// rather than let it fall ever further behind: below two pictures a second, time in the game runs slower
/// than outside.
class StepClock {
public:
    static constexpr double k_longest_picture_s = 0.5;

    /// Adds real time. @return  how many steps to simulate now
    [[nodiscard]] std::uint32_t advance(double elapsed_s);

    /// Where the picture lies between the step before (0) and the newest (1).
    [[nodiscard]] float interpolation() const { return static_cast<float>(left_s_ / systems::k_step_s); }

private:
    double left_s_ = 0.0;
};

/// What to simulate for a picture of a given moment: the newest step, and where the moment lies behind the
/// one before.
struct StepsAt {
    std::uint64_t steps = 0;
    float interpolation = 1.0f;
};
[[nodiscard]] StepsAt steps_at(double time_s);

}  // namespace rambla::game
