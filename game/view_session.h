#pragma once

#include "game/app.h"
#include "game/clips.h"
#include "game/framing.h"
#include "game/model_view.h"

namespace rambla::game {

/// Turns around a model: the left button orbits, the wheel comes nearer or goes farther. Its clips play, and
/// until the mouse is used the picture follows the file's camera.
class ViewSession {
public:
    /// @param view  must outlive this
    explicit ViewSession(ModelView& view);

    [[nodiscard]] Shot update(const Moment& moment);

    /// Its widgets in the overlay.
    void draw_overlay_part();

private:
    void follow_mouse(const Input& input);

    ModelView& view_;
    std::optional<Orbit> orbit_;  ///< none before the mouse has been used
    ClipPlayback clips_;
};

}  // namespace rambla::game
