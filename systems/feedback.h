#pragma once

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
};

/// What the renderer tells a later frame: plain data, never read by the simulation.
struct Feedback {
    std::uint64_t frame = 0;
    std::vector<PassTiming> passes;
    double gpu_frame_ms = 0.0;  ///< the frame's envelope on the GPU
    double cpu_frame_ms = 0.0;  ///< render thread, submission included
    std::uint32_t draws = 0;    ///< indirect commands drawn, all passes
    std::uint64_t triangles = 0;
    std::uint64_t gl_calls = 0;           ///< since the frame before, looks at fences left out
    std::uint64_t gl_state_changes = 0;   ///< of those, what binds or sets state
    std::uint64_t gl_blocking_calls = 0;  ///< of those, what waits for a result of the GPU
    std::uint64_t gl_pacing_waits = 0;    ///< besides those: for room, as only so many frames are in flight
    std::uint32_t gl_objects = 0;         ///< alive at the frame's end
    std::uint64_t gpu_memory_bytes = 0;   ///< buffers and textures that the renderer holds
};

}  // namespace rambla::systems
