#pragma once

#include <chrono>
#include <cstdint>

namespace rambla::render::graph {

/// Turns time stamps of the GPU into moments of this process's steady clock. The two run from different
/// zeros, and drift apart: by up to 0.1 ms a second, as quartzes do.
class GpuClock {
public:
    /// Reads both clocks, unless that was done within the last second. Needs a current context.
    void compare();

    /// When a GL_TIMESTAMP was taken; compare() comes first.
    [[nodiscard]] std::chrono::steady_clock::time_point moment(std::uint64_t stamp_ns) const;

private:
    std::chrono::steady_clock::time_point compared_{};  ///< the epoch: never
    std::int64_t stamp_ns_ = 0;                         ///< of the GPU, at that moment
};

}  // namespace rambla::render::graph
