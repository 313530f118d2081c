// Built without thread-sanitizer instrumentation (see CMakeLists.txt): oneTBB's templates hand tasks from
// thread to thread by means that the sanitizer cannot see. What it must know is said by hand: a release where
// work is handed over, an acquire where it is taken up.
#include "ecs/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#if defined(RAMBLA_ECS_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace rambla::ecs {
namespace {

#if defined(RAMBLA_ECS_THREAD_SANITIZER)
void hand_over(void* what) {
    __tsan_release(what);
}
void take_up(void* what) {
    __tsan_acquire(what);
}
#else
void hand_over(void*) {}
void take_up(void*) {}
#endif

/// Long enough for any system that grants the threads at all.
constexpr std::chrono::seconds k_longest_muster{1};

std::uint64_t next_team_number() {
    static std::atomic<std::uint64_t> next{1};
    return next.fetch_add(1, std::memory_order_relaxed);
}

/// Team that this thread ran a job of last: spares it the roll call.
constinit thread_local std::uint64_t t_known_to = 0;

}  // namespace

struct Team::Impl {
    std::optional<tbb::global_control> more_than_cores;
    tbb::task_arena arena{1};
    tbb::task_group group;
    std::size_t threads = 1;
    const std::uint64_t number = next_team_number();

    std::mutex roll_guard;
    std::vector<std::thread::id> roll;
    std::atomic<std::size_t> roll_size{0};

    void answer_roll() {
        if (t_known_to == number) return;
        t_known_to = number;
        const std::lock_guard lock{roll_guard};
        const std::thread::id self = std::this_thread::get_id();
        if (std::find(roll.begin(), roll.end(), self) != roll.end()) return;
        roll.push_back(self);
        roll_size.store(roll.size(), std::memory_order_relaxed);
    }

    /// One job per thread, none of which ends before all have begun: so each needs a thread of its own.
    void muster() {
        const std::size_t expected = std::min(threads, allowed_threads());
        std::atomic<std::size_t> arrived{0};
        const auto deadline = std::chrono::steady_clock::now() + k_longest_muster;
        const auto report = [&] {
            take_up(this);
            answer_roll();
            arrived.fetch_add(1);
            while (arrived.load() < expected && std::chrono::steady_clock::now() < deadline)
                std::this_thread::yield();
            hand_over(this);
        };
        hand_over(this);
        arena.execute([&] {
            for (std::size_t i = 1; i < expected; ++i)
                group.run(report);
            report();
            group.wait();
        });
        take_up(this);
    }
};

Team::Team() : impl_{std::make_unique<Impl>()} {}

Team::~Team() = default;

void Team::resize(std::size_t threads) {
    threads = std::max<std::size_t>(threads, 1);
    if (threads == impl_->threads) return;
    impl_->arena.terminate();
    impl_->more_than_cores.reset();
    if (threads > allowed_threads())
        impl_->more_than_cores.emplace(tbb::global_control::max_allowed_parallelism, threads);
    impl_->arena.initialize(static_cast<int>(threads));
    impl_->threads = threads;
    impl_->muster();
}

std::size_t Team::threads() const {
    return impl_->threads;
}

std::size_t Team::worker_threads() const {
    return impl_->roll_size.load(std::memory_order_relaxed);
}

void Team::enter_with(void (*job)(void*), void* argument) {
    impl_->arena.execute([&] {
        impl_->answer_roll();
        job(argument);
    });
}

void Team::for_ranges_with(std::size_t count, std::size_t grain, void (*job)(void*, std::size_t, std::size_t),
                           void* argument) {
    char begun = 0;
    char ended = 0;
    hand_over(&begun);
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>{0, count, std::max<std::size_t>(grain, 1)},
            [&](const tbb::blocked_range<std::size_t>& range) {
                take_up(&begun);
                impl_->answer_roll();
                job(argument, range.begin(), range.end());
                hand_over(&ended);
            },
            tbb::simple_partitioner{});
    });
    take_up(&ended);
}

void Team::spawn(void (*job)(void*), void* argument) {
    Impl* const impl = impl_.get();
    hand_over(argument);
    impl->group.run([impl, job, argument] {
        take_up(argument);
        impl->answer_roll();
        job(argument);
        hand_over(impl);
    });
}

void Team::wait() {
    impl_->group.wait();
    take_up(impl_.get());
}

void for_ranges(std::size_t count, std::size_t grain, void (*f)(void*, std::size_t, std::size_t),
                void* argument) {
    char begun = 0;
    char ended = 0;
    hand_over(&begun);
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>{0, count, std::max<std::size_t>(grain, 1)},
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              take_up(&begun);
                              f(argument, range.begin(), range.end());
                              hand_over(&ended);
                          });
    });
    take_up(&ended);
}

std::size_t Team::allowed_threads() {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

}  // namespace rambla::ecs
