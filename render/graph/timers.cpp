#include "render/graph/timers.h"

#include <optional>

#include "assets/assert.h"

namespace rambla::render::graph {

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

void stamp(gl::Query& query) {
    if (!query) query = gl::Query{"time stamp", GL_TIMESTAMP};
    glQueryCounter(query.name(), GL_TIMESTAMP);
}

void stamp_alone(gl::Query& query) {
    stamp(query);
    glFlush();
}

}  // namespace

void Timers::begin_frame(PassTimers timers) {
    if (executed_ - taken_ == k_frames) ++taken_;  // nobody asked for the oldest
    Record& record = current();
    record.timers = timers;
    record.cost.passes.clear();
    record.stamped.clear();
    record.cost.gpu_ms = 0.0;
    record.cost.gpu_begin = {};
    if (timers == PassTimers::off) return;
    clock_.compare();
    stamp_alone(record.envelope.begin);
}

void Timers::begin_pass(const char* name, bool draws, std::uint64_t bytes_written,
                        std::uint64_t memory_bytes) {
    Record& record = current();
    const std::size_t index = record.cost.passes.size();
    const bool timed = record.timers != PassTimers::off;
    const bool stamped = timed && (draws || record.timers == PassTimers::stamped);
    record.stamped.push_back(stamped ? 1 : 0);
    if (index == record.spans.size()) record.spans.emplace_back();
    if (stamped) {
        stamp_alone(record.spans[index].begin);
    } else if (timed) {
        glFinish();
    }
    record.cost.passes.push_back({.name = name,
                                  .bytes_written = bytes_written,
                                  .memory_bytes = memory_bytes,
                                  .cpu_begin = Clock::now()});
}

void Timers::end_pass() {
    Record& record = current();
    PassCost& cost = record.cost.passes.back();
    cost.cpu_ms = Milliseconds{Clock::now() - cost.cpu_begin}.count();
    if (record.timers == PassTimers::off) return;
    if (record.stamped.back() != 0) {
        stamp(record.spans[record.cost.passes.size() - 1].end);
    } else {
        glFinish();
        cost.gpu_begin = cost.cpu_begin;
        cost.gpu_ms = Milliseconds{Clock::now() - cost.cpu_begin}.count();
    }
}

void Timers::end_frame() {
    if (current().timers != PassTimers::off) stamp_alone(current().envelope.end);
    ++executed_;
}

const FrameCost& Timers::take() {
    RAMBLA_ASSERT(taken_ < executed_, "costs are taken once for each executed frame");
    Record& record = records_[taken_++ % k_frames];
    if (record.timers == PassTimers::off) return record.cost;
    const auto read = [this](const Span& span, auto& cost) {
        const std::optional<std::uint64_t> begin_ns = span.begin.result();
        const std::optional<std::uint64_t> end_ns = span.end.result();
        if (!begin_ns || !end_ns) return;
        cost.gpu_begin = clock_.moment(*begin_ns);
        cost.gpu_ms = Milliseconds{clock_.moment(*end_ns) - cost.gpu_begin}.count();
    };
    for (std::size_t i = 0; i < record.cost.passes.size(); ++i) {
        if (record.stamped[i] != 0) read(record.spans[i], record.cost.passes[i]);
    }
    read(record.envelope, record.cost);
    return record.cost;
}

}  // namespace rambla::render::graph
