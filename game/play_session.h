#pragma once

#include "game/app.h"
#include "game/player.h"
#include "game/step_clock.h"

namespace rambla::game {

/// A walk of one's own: turns keys and mouse into steps of player and world.
class PlaySession {
public:
    /// Starts where the stage's standard walk starts; the stage must outlive this.
    explicit PlaySession(Stage& stage);

    /// Simulates the steps that have become due and returns what is to be seen.
    [[nodiscard]] Shot update(const Moment& moment);

    [[nodiscard]] const Player& player() const { return now_; }
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

private:
    /// Adds what the user asked for since the picture before to what the next step shall do.
    void listen(const Moment& moment);

    Stage& stage_;
    Surroundings surroundings_;
    Player before_;
    Player now_;
    StepClock clock_;
    PlayerIntent intent_;
    std::uint64_t steps_ = 0;
};

}  // namespace rambla::game
