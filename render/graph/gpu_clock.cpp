#include "render/graph/gpu_clock.h"

#include <epoxy/gl.h>

namespace rambla::render::graph {

using Clock = std::chrono::steady_clock;

void GpuClock::compare() {
    constexpr std::chrono::seconds k_good_for{1};
    const Clock::time_point before = Clock::now();
    if (compared_ != Clock::time_point{} && before - compared_ < k_good_for) return;
    GLint64 stamp_ns = 0;
    glGetInteger64v(GL_TIMESTAMP, &stamp_ns);
    // The GPU was asked somewhere between the two readings of our clock.
    compared_ = before + (Clock::now() - before) / 2;
    stamp_ns_ = stamp_ns;
}

Clock::time_point GpuClock::moment(std::uint64_t stamp_ns) const {
    const std::int64_t later_ns = static_cast<std::int64_t>(stamp_ns) - stamp_ns_;
    return compared_ + std::chrono::duration_cast<Clock::duration>(std::chrono::nanoseconds{later_ns});
}

}  // namespace rambla::render::graph
