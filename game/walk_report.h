#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "game/run_stats.h"
#include "systems/feedback.h"
#include "systems/frame.h"

namespace rambla::game {

/// Milliseconds of one system of the simulation or the look, once per frame.
struct SystemSamples {
    std::string name;
    std::vector<double> ms;
};

/// Where the time went before the first frame; wall time, one after the other.
struct StartMeasures {
    double generating_ms = 0.0;  ///< the scene and its world
    double loading_ms = 0.0;     ///< what was processed by an earlier start
    double processing_ms = 0.0;  ///< meshes and textures that the cache did not have
    double uploading_ms = 0.0;   ///< to the graphics card, and compiling shaders
    std::uint32_t cache_hits = 0;
    std::uint32_t cache_misses = 0;
};

/// What was measured while a walk was drawn.
struct WalkMeasures {
    StartMeasures start;
    std::string scene;
    std::uint64_t seed = 0;
    glm::uvec2 size_px{0};
    double walk_s = 0.0;  ///< duration of the way itself
    double run_s = 0.0;   ///< how long drawing and encoding took
    std::uint64_t steps = 0;
    std::size_t entities = 0;
    systems::FrameCounts counts;  ///< of the last frame
    std::uint32_t most_visible_lights = 0;
    std::vector<double> frame_ms;  ///< from frame to frame, once the queue is full
    std::vector<SystemSamples> systems;
    std::vector<HeldSample> held;             ///< after each frame
    std::vector<systems::Feedback> drawn;     ///< without timers
    std::vector<systems::Feedback> profiled;  ///< with timers
};

/// What textures took, for machines.
[[nodiscard]] nlohmann::json textures_json(const systems::TextureFeedback& textures);

/// The walk in a few lines: speed, contents, systems, memory.
[[nodiscard]] std::string summary_text(const WalkMeasures& measures);
[[nodiscard]] nlohmann::json summary_json(const WalkMeasures& measures);

}  // namespace rambla::game
