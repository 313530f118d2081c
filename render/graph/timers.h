#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

#include "render/gl/query.h"
#include "render/graph/cost.h"

namespace rambla::render::graph {

/// Clocks of the frames in flight. On the GPU only on request: the software rasteriser executes lazily, so a
/// query measures its pass only when the work before it is flushed, and that costs what it costs. Dispatches
/// and copies are not seen by its queries at all: what draws nothing is measured by the wall instead, between
/// two moments at which the GPU has nothing left to do.
class Timers {
public:
    /// More frames than the renderer lets be in flight, so that none is taken while another begins.
    static constexpr std::size_t k_frames = 4;

    void begin_frame(bool profile);
    /// @param draws  into attachments
    void begin_pass(const char* name, bool draws, std::uint64_t bytes_written, std::uint64_t memory_bytes);
    void end_pass();
    void end_frame();

    /// Costs of the oldest frame not yet taken; waits for its queries. The reference is valid until the next
    /// call.
    [[nodiscard]] const FrameCost& take();

private:
    struct Record {
        bool profiled = false;
        FrameCost cost;
        std::vector<std::uint8_t> draws;  ///< per pass
        std::vector<gl::Query> elapsed;   ///< one per pass, kept for later frames
        gl::Query begin;
        gl::Query end;
    };
    std::array<Record, k_frames> records_;
    std::uint64_t executed_ = 0;
    std::uint64_t taken_ = 0;
    std::chrono::steady_clock::time_point pass_begin_;

    [[nodiscard]] Record& current() { return records_[executed_ % k_frames]; }
};

}  // namespace rambla::render::graph
