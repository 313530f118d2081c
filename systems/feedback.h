#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace rambla::systems {

/// Cost of one pass of one drawn frame.
struct PassTiming {
    std::string name;
    double gpu_ms = 0.0;
    double cpu_ms = 0.0;
    std::uint64_t bytes_written = 0;  ///< attachments' bytes that the pass may write
    std::uint64_t memory_bytes = 0;   ///< transient textures and buffers alive while it runs
    std::chrono::steady_clock::time_point cpu_begin{};
    std::chrono::steady_clock::time_point gpu_begin{};  ///< the epoch: not timed on the GPU
};

/// What the images of a scene take whose levels come and go.
struct TextureFeedback {
    std::uint64_t resident_bytes = 0;  ///< with what is being replaced
    std::uint64_t peak_bytes = 0;      ///< most that resident_bytes has been at any moment
    std::uint64_t budget_bytes = 0;
    std::uint64_t loads = 0;  ///< of levels of an image, so far
    std::uint32_t pending_loads = 0;
    std::uint32_t below_demand = 0;  ///< images that the picture shows less finely than it could
};

/// What automatic exposure has seen and done.
struct ExposureFeedback {
    bool known = false;              ///< the picture's luminance was looked at
    double departure_ev = 0.0;       ///< from the exposure that the settings say
    double average_luminance = 0.0;  ///< log-average of exposed light before that departure
    std::uint32_t bad_pixels = 0;    ///< infinite or NaN before tone mapping
};

/// What the renderer tells a later frame: plain data, never read by the simulation.
struct Feedback {
    std::uint64_t frame = 0;
    std::vector<PassTiming> passes;
    double gpu_frame_ms = 0.0;                          ///< the frame's envelope on the GPU
    double cpu_frame_ms = 0.0;                          ///< render thread, submission included
    std::chrono::steady_clock::time_point cpu_begin{};  ///< of the frame
    std::chrono::steady_clock::time_point gpu_begin{};  ///< of the envelope; the epoch: not timed
    std::uint32_t draws = 0;                            ///< indirect commands drawn, all passes
    std::uint64_t triangles = 0;
    std::uint64_t gl_calls = 0;           ///< since the frame before, looks at fences left out
    std::uint64_t gl_state_changes = 0;   ///< of those, what binds or sets state
    std::uint64_t gl_blocking_calls = 0;  ///< of those, what waits for a result of the GPU
    std::uint64_t gl_pacing_waits = 0;    ///< besides those: for room, as only so many frames are in flight
    std::uint32_t gl_objects = 0;         ///< alive at the frame's end, but for textures being replaced
    std::uint64_t gpu_memory_bytes = 0;   ///< buffers and textures that the renderer holds
    TextureFeedback textures;
    ExposureFeedback exposure;
};

}  // namespace rambla::systems
