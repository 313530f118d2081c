#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "systems/feedback.h"

namespace rambla::game {

/// What one pass cost over a run.
struct PassRow {
    std::string name;
    double gpu_ms_median = 0.0;
    double gpu_ms_p99 = 0.0;
    double share = 0.0;  ///< of the frame's median envelope, 0 to 1
    double cpu_ms_median = 0.0;
    double bytes_written = 0.0;  ///< per frame, median
    double memory_bytes = 0.0;   ///< transient memory alive while it runs, most of all frames
    std::uint32_t frames = 0;    ///< in how many of the run's frames the pass ran
};

/// Per-pass costs of a run. A pass that did not run in a frame counts as 0 ms there, so that medians are of
/// the run.
struct PassTable {
    std::vector<PassRow> passes;  ///< in order of first appearance
    PassRow missing;  ///< the envelope's part that no pass accounts for; negative if they exceed it
    PassRow frame;    ///< the envelope
    std::uint64_t gpu_memory_bytes = 0;
    std::uint32_t draws = 0;  ///< median per frame
    std::uint64_t triangles = 0;
};

/// @param frames  feedback of profiled frames, in any number
[[nodiscard]] PassTable make_pass_table(const std::vector<systems::Feedback>& frames);

/// The table as aligned text, for people.
[[nodiscard]] std::string to_text(const PassTable& table);

[[nodiscard]] nlohmann::json to_json(const PassTable& table);

/// "1.5 GiB", "340 KiB", "12 B".
[[nodiscard]] std::string bytes_text(double bytes);

}  // namespace rambla::game
