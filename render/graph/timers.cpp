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
    record.draws.clear();
    record.cost.gpu_ms = 0.0;
    if (profile) stamp(record.begin);
}

void Timers::begin_pass(const char* name, bool draws, std::uint64_t bytes_written,
                        std::uint64_t memory_bytes) {
    Record& record = current();
    const std::size_t index = record.cost.passes.size();
    record.cost.passes.push_back(
        {.name = name, .bytes_written = bytes_written, .memory_bytes = memory_bytes});
    record.draws.push_back(draws ? 1 : 0);
    if (index == record.elapsed.size()) record.elapsed.emplace_back();
    if (record.profiled && draws) {
        if (!record.elapsed[index]) record.elapsed[index] = gl::Query{"pass", GL_TIME_ELAPSED};
        glBeginQuery(GL_TIME_ELAPSED, record.elapsed[index].name());
        glFlush();
    } else if (record.profiled) {
        glFinish();
    }
    pass_begin_ = std::chrono::steady_clock::now();
}

void Timers::end_pass() {
    Record& record = current();
    using Milliseconds = std::chrono::duration<double, std::milli>;
    PassCost& cost = record.cost.passes.back();
    cost.cpu_ms = Milliseconds{std::chrono::steady_clock::now() - pass_begin_}.count();
    if (!record.profiled) return;
    if (record.draws.back() != 0) {
        glEndQuery(GL_TIME_ELAPSED);
    } else {
        glFinish();
        cost.gpu_ms = Milliseconds{std::chrono::steady_clock::now() - pass_begin_}.count();
    }
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
            if (record.draws[i] == 0) continue;
            record.cost.passes[i].gpu_ms = static_cast<double>(record.elapsed[i].result()) * k_ms_per_ns;
        }
        record.cost.gpu_ms = static_cast<double>(record.end.result() - record.begin.result()) * k_ms_per_ns;
    }
    return record.cost;
}

}  // namespace rambla::render::graph
