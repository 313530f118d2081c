#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "game/input.h"
#include "game/run_trace.h"
#include "game/stage.h"
#include "render/settings.h"

namespace rambla::game {

struct AppOptions {
    std::string title;
    glm::uvec2 size_px{960, 540};
    bool walking =
        false;           ///< the pointer belongs to somebody's eyes, and the help names the keys for walking
    bool quiet = false;  ///< shows no progress on the terminal
    std::uint64_t frames = 0;              ///< ends after so many pictures; 0: when the user quits
    RunTrace* trace = nullptr;             ///< gets every step and frame; may be null
    std::function<void()> overlay_part{};  ///< widgets of the caller's own, below the overlay's; may be empty
};

/// What to show next.
struct Shot {
    systems::Eye eye;            ///< its size is the window's
    float interpolation = 1.0f;  ///< between the step before (0) and the newest (1)
    std::uint64_t steps = 0;     ///< simulated so far
    std::string caption{};       ///< one line over the picture; may be empty
};

/// What an update learns of its user.
struct Moment {
    double elapsed_s = 0.0;  ///< since the picture before; 0 while paused
    const Input& input;
    bool keys_free = true;     ///< keys are not being typed into a field
    bool pointer_free = true;  ///< the pointer is not on a panel
};
using Update = std::function<Shot(const Moment&)>;

/// Shows a stage in a window until the user quits: help, pause, timings, overlay, full screen, screenshots,
/// and shaders that are compiled anew when their files change. `update` advances what is the caller's own.
/// @return  the number of pictures drawn
/// @throws MachineLacks, render::MissingFeature
std::uint64_t run_app(const AppOptions& options, Stage& stage, const render::Settings& settings,
                      const Update& update);

}  // namespace rambla::game
