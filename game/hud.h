#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "game/pass_table.h"
#include "systems/feedback.h"

namespace rambla::game {

/// Pass times of the newest frames, as the timings panel shows them: a table anew a few times a second, so
/// that it can be read.
class TimingsPanel {
public:
    void add(systems::Feedback feedback);
    [[nodiscard]] const PassTable& table() const { return table_; }
    [[nodiscard]] const systems::Feedback& newest() const { return newest_; }

private:
    static constexpr std::size_t k_frames_per_table = 16;
    systems::Feedback newest_;
    std::vector<systems::Feedback> collected_;
    PassTable table_;
};

/// What lies over the picture.
struct Hud {
    bool help = false;
    bool timings = false;
    bool paused = false;
    bool walking = true;       ///< whether there is somebody to walk: which keys the help names
    double picture_ms = 0.0;   ///< time between two pictures
    std::string caption;       ///< one line at the bottom, of what is shown
    std::string notice;        ///< in its place for a while, such as where a screenshot went
    std::string shader_error;  ///< of the last reload; empty when it went well
};

/// Builds the HUD's windows in the current Dear ImGui frame.
void draw_hud(const Hud& hud, const TimingsPanel& timings);

}  // namespace rambla::game
