#pragma once

#include "game/app.h"
#include "game/clips.h"
#include "game/framing.h"

namespace rambla::game {

/// Turns around a model: the left button orbits, the wheel comes nearer or goes farther. Its clips play.
class ViewSession {
public:
    /// @param start  where to look from until the mouse is used
    /// @param box    what is looked at
    ViewSession(Stage& stage, const systems::Eye& start, const assets::Bounds& box);

    [[nodiscard]] Shot update(const Moment& moment);

private:
    systems::WorldPosition origin_;
    systems::Eye eye_;
    Orbit orbit_;
    ClipPlayback clips_;
};

}  // namespace rambla::game
