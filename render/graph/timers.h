#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

#include "render/gl/query.h"
#include "render/graph/cost.h"
#include "render/graph/gpu_clock.h"

namespace rambla::render::graph {

/// Clocks of the frames in flight. On the GPU only on request: the software rasteriser executes lazily, so a
/// stamp tells when its pass begins only when the work before it is flushed, and that costs what it costs. It
/// runs dispatches and copies at once, when they are called: what draws nothing is therefore, with
/// PassTimers::alone, measured by the wall instead, between two moments at which the GPU has nothing left to
/// do.
class Timers {
public:
    /// More frames than the renderer lets be in flight, so that none is taken while another begins.
    static constexpr std::size_t k_frames = 4;

    void begin_frame(PassTimers timers);
    /// @param draws  into attachments
    void begin_pass(const char* name, bool draws, std::uint64_t bytes_written, std::uint64_t memory_bytes);
    void end_pass();
    void end_frame();

    /// Costs of the oldest frame not yet taken, whose fence has passed: what the GPU has not done yet counts
    /// as not timed. The reference is valid until the next call.
    [[nodiscard]] const FrameCost& take();

private:
    /// Time stamps around something.
    struct Span {
        gl::Query begin;
        gl::Query end;
    };
    struct Record {
        PassTimers timers = PassTimers::off;
        FrameCost cost;
        std::vector<std::uint8_t> stamped;  ///< per pass: the queries say when it ran
        std::vector<Span> spans;            ///< one per pass, kept for later frames
        Span envelope;
    };
    std::array<Record, k_frames> records_;
    std::uint64_t executed_ = 0;
    std::uint64_t taken_ = 0;
    GpuClock clock_;

    [[nodiscard]] Record& current() { return records_[executed_ % k_frames]; }
};

}  // namespace rambla::render::graph
