#include "render/graph/timers.h"

#include "assets/assert.h"

namespace rambla::render::graph {

namespace {

constexpr double k_ms_per_ns = 1e-6;

void stamp(gl::Query& query) {
    if (!query) query = gl::Query{"frame", GL_TIMESTAMP};
    glQueryCounter(query.name(), GL_TIMESTAMP);
    glFlush();
}

}  // namespace

void Timers::begin_frame(bool profile) {
    if (executed_ - taken_ == k_frames) ++taken_;  // nobody asked for the oldest
    Record& record = current();
    record.profiled = profile;
    record.cost.passes.clear();
    record.cost.gpu_ms = 0.0;
    if (profile) stamp(record.begin);
}

void Timers::begin_pass(const char* name, std::uint64_t bytes_written, std::uint64_t memory_bytes) {
    Record& record = current();
    const std::size_t index = record.cost.passes.size();
    record.cost.passes.push_back(
        {.name = name, .bytes_written = bytes_written, .memory_bytes = memory_bytes});
    if (record.profiled) {
        if (index == record.elapsed.size()) record.elapsed.emplace_back("pass", GL_TIME_ELAPSED);
        glBeginQuery(GL_TIME_ELAPSED, record.elapsed[index].name());
        glFlush();
    }
    pass_begin_ = std::chrono::steady_clock::now();
}

void Timers::end_pass() {
    Record& record = current();
    const std::chrono::duration<double, std::milli> cpu = std::chrono::steady_clock::now() - pass_begin_;
    record.cost.passes.back().cpu_ms = cpu.count();
    if (record.profiled) glEndQuery(GL_TIME_ELAPSED);
}

void Timers::end_frame() {
    if (current().profiled) stamp(current().end);
    ++executed_;
}

const FrameCost& Timers::take() {
    RAMBLA_ASSERT(taken_ < executed_, "costs are taken once for each executed frame");
    Record& record = records_[taken_++ % k_frames];
    if (record.profiled) {
        for (std::size_t i = 0; i < record.cost.passes.size(); ++i) {
            record.cost.passes[i].gpu_ms = static_cast<double>(record.elapsed[i].result()) * k_ms_per_ns;
        }
        record.cost.gpu_ms = static_cast<double>(record.end.result() - record.begin.result()) * k_ms_per_ns;
    }
    return record.cost;
}

}  // namespace rambla::render::graph
