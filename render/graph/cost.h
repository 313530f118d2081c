#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

namespace rambla::render {

/// How the passes of a frame are timed on the GPU.
enum class PassTimers : std::uint8_t {
    off,
    stamped,  ///< each pass's begin and end, at the price of a flush per pass; nothing waits
    alone     ///< for what passes cost: besides, what draws nothing runs between two waits for the GPU
};

/// Time and traffic of one executed pass.
struct PassCost {
    const char* name = "";
    double gpu_ms = 0.0;  ///< 0 when not timed
    double cpu_ms = 0.0;
    std::uint64_t bytes_written = 0;
    std::uint64_t memory_bytes = 0;  ///< transient memory alive while it runs
    std::chrono::steady_clock::time_point cpu_begin{};
    std::chrono::steady_clock::time_point gpu_begin{};  ///< the epoch when not timed
};

/// Costs of one frame, complete when the GPU has finished it.
struct FrameCost {
    std::vector<PassCost> passes;
    double gpu_ms = 0.0;                                ///< envelope of all passes; 0 when not timed
    std::chrono::steady_clock::time_point gpu_begin{};  ///< of the envelope; the epoch when not timed
};

}  // namespace rambla::render
