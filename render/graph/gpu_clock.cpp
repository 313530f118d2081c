#include "render/graph/gpu_clock.h"

#include <epoxy/gl.h>

namespace rambla::render::graph {

using Clock = std::chrono::steady_clock;

void GpuClock::compare() {
    constexpr std::chrono::seconds k_good_for{1};
    const Clock::time_point before = Clock::now();
    if (compared_ != Clock::time_point{} && before - compared_ < k_good_for) return;
    // The GPU was asked somewhere between two readings of our clock: the closer they are, the better. This
    // thread may be put aside in between.
    Clock::duration shortest = Clock::duration::max();
    for (int reading = 0; reading < 3; ++reading) {
        const Clock::time_point asked = Clock::now();
        GLint64 stamp_ns = 0;
        glGetInteger64v(GL_TIMESTAMP, &stamp_ns);
        const Clock::duration took = Clock::now() - asked;
        if (took >= shortest) continue;
        shortest = took;
        compared_ = asked + took / 2;
        stamp_ns_ = stamp_ns;
    }
}

Clock::time_point GpuClock::moment(std::uint64_t stamp_ns) const {
    const std::int64_t later_ns = static_cast<std::int64_t>(stamp_ns) - stamp_ns_;
    return compared_ + std::chrono::duration_cast<Clock::duration>(std::chrono::nanoseconds{later_ns});
}

}  // namespace rambla::render::graph
