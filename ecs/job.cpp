#include "ecs/job.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>

#include "ecs/access_scope.h"
#include "ecs/iteration.h"

namespace rambla::ecs::detail {
namespace {

/// Below this, waking another thread and fetching what it wrote cost more than they save.
constexpr double k_shortest_shared_ns = 10'000.0;
constexpr double k_shortest_job_ns = k_shortest_shared_ns / 2;
/// So that a thread that comes late, or is sent away, does not keep all others waiting.
constexpr std::size_t k_jobs_per_thread = 8;

/// The exception of the job with the smallest number.
class FirstError {
public:
    void keep(std::size_t job) {
        const std::lock_guard lock{guard_};
        if (error_ != nullptr && job_ < job) return;
        job_ = job;
        error_ = std::current_exception();
    }
    void rethrow() const {
        if (error_ != nullptr) std::rethrow_exception(error_);
    }

private:
    std::mutex guard_;
    std::size_t job_ = 0;
    std::exception_ptr error_;
};

}  // namespace

std::uint32_t SystemContext::open_jobs(std::uint32_t count) {
    const std::uint32_t first = job_count;
    job_count += count;
    for (JobLanes* const one : lanes)
        one->open(job_count);
    return first;
}

std::size_t LoopCost::grain(std::size_t chunks, std::size_t rows, std::size_t threads) const {
    const double total_ns = ns_per_row_ * static_cast<double>(rows);
    if (threads < 2 || chunks < 2 || total_ns < k_shortest_shared_ns) return chunks;
    const double jobs =
        std::min(total_ns / k_shortest_job_ns, static_cast<double>(threads * k_jobs_per_thread));
    return static_cast<std::size_t>(std::ceil(static_cast<double>(chunks) / jobs));
}

void LoopCost::measured(std::size_t rows, std::uint64_t ns) {
    if (rows == 0) return;
    const double now = static_cast<double>(ns) / static_cast<double>(rows);
    ns_per_row_ = known_ ? 0.5 * (ns_per_row_ + now) : now;
    known_ = true;
}

void run_jobs(const SystemContext& context, LoopCost& cost, std::size_t count, std::size_t rows,
              void (*chunk_job)(void*, std::size_t, std::size_t), void* argument) {
    using Clock = std::chrono::steady_clock;
    FirstError error;
    std::atomic<std::uint64_t> spent_ns{0};
    const auto run_range = [&](std::size_t begin, std::size_t end) {
        const AccessScope scope{*context.world, context.name, *context.access};
        const IterationMark mark{*context.world, &context};
        const Clock::time_point start = Clock::now();
        for (std::size_t i = begin; i < end; ++i) {
            try {
                chunk_job(argument, i, begin);
            } catch (...) {
                error.keep(i);
            }
        }
        const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count();
        spent_ns.fetch_add(static_cast<std::uint64_t>(ns), std::memory_order_relaxed);
    };
    const std::size_t grain = cost.grain(count, rows, context.team == nullptr ? 1 : context.team->threads());
    if (grain >= count) {
        run_range(0, count);
    } else {
        context.team->for_ranges(count, grain, run_range);
    }
    cost.measured(rows, spent_ns.load(std::memory_order_relaxed));
    error.rethrow();
}

}  // namespace rambla::ecs::detail
