#pragma once

#include <cstdint>
#include <vector>

namespace rambla::render {

/// Time and traffic of one executed pass.
struct PassCost {
    const char* name = "";
    double gpu_ms = 0.0;  ///< 0 when not profiled
    double cpu_ms = 0.0;
    std::uint64_t bytes_written = 0;
    std::uint64_t memory_bytes = 0;  ///< transient memory alive while it runs
};

/// Costs of one frame, complete when the GPU has finished it.
struct FrameCost {
    std::vector<PassCost> passes;
    double gpu_ms = 0.0;  ///< envelope of all passes; 0 when not profiled
};

}  // namespace rambla::render
