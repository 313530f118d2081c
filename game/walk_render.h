#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "game/options.h"
#include "game/run_stats.h"
#include "game/run_trace.h"
#include "game/stage.h"

namespace rambla::game {

/// How a walk is drawn.
struct WalkRender {
    std::uint32_t frames = 96;
    std::filesystem::path folder = "out/walk";
    std::string format = "png";  ///< or exr
    std::uint32_t profile_frames = 12;
    std::filesystem::path graph;  ///< empty: not drawn
    bool stats = false;
    double generating_ms = 0.0;  ///< what making the stage took, for the report
    RunTrace* trace = nullptr;   ///< gets every frame, with its passes' times on the GPU; may be null
};

struct WalkResult {
    std::uint64_t steps = 0;  ///< simulated
    Steadiness steadiness;
    std::string text;     ///< for people, the table included
    nlohmann::json json;  ///< the same for machines
};

/// Draws a stage's walk and writes frames, contact sheet (contact.png) and pass table (passes.txt) into the
/// folder.
/// @throws MachineLacks, render::MissingFeature, assets::Error
[[nodiscard]] WalkResult render_walk(Stage& stage, const Options& options, const WalkRender& walk);

}  // namespace rambla::game
