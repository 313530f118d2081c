#pragma once

#include "game/clips.h"

namespace rambla::game {

/// Builds the clips' part of the overlay in the current Dear ImGui window: a list to choose from, the time to
/// drag, the speed. Nothing where there are no clips.
void draw_clip_panel(ClipPlayback& clips);

}  // namespace rambla::game
