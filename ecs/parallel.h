#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <type_traits>

namespace rambla::ecs {

/// Threads that work together on oneTBB: the caller of enter() and workers that join it. All parallelism of
/// the room goes through here, so that one place tells the thread sanitizer what happens before what (oneTBB
/// itself is not instrumented).
///
/// Jobs must not throw. A thread that waits for its ranges runs only jobs of these ranges meanwhile.
class Team {
public:
    Team();
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// Waits for the workers to come, so that the first jobs find them awake; where the system, or somebody's
    /// tbb::global_control, grants fewer, goes on with those after a while.
    /// @param threads  caller included, at least 1; may be more than there are cores
    void resize(std::size_t threads);
    /// As resize() was asked for, or was granted.
    [[nodiscard]] std::size_t threads() const;
    /// Distinct threads that have run jobs of this team, the start-up job of resize() included.
    [[nodiscard]] std::size_t worker_threads() const;

    /// Calls f() as one of the team: where spawn() and for_ranges() may be used.
    template <class F>
    void enter(F&& f) {
        enter_with(&call<std::remove_reference_t<F>>, address_of(f));
    }

    /// Calls f(begin, end) for ranges of at most `grain` that cover [0, count), and waits for all.
    template <class F>
    void for_ranges(std::size_t count, std::size_t grain, F&& f) {
        for_ranges_with(count, grain, &call_range<std::remove_reference_t<F>>, address_of(f));
    }

    /// Starts job(argument) on some thread, now or later.
    void spawn(void (*job)(void*), void* argument);
    /// Until all that was spawned has ended; runs some of it.
    void wait();

    /// How many threads oneTBB allows now: all cores unless a tbb::global_control says otherwise.
    [[nodiscard]] static std::size_t allowed_threads();

private:
    struct Impl;

    template <class F>
    static void* address_of(F& f) {
        return const_cast<void*>(static_cast<const void*>(std::addressof(f)));
    }
    template <class F>
    static void call(void* f) {
        (*static_cast<F*>(f))();
    }
    template <class F>
    static void call_range(void* f, std::size_t begin, std::size_t end) {
        (*static_cast<F*>(f))(begin, end);
    }
    void enter_with(void (*job)(void*), void* argument);
    void for_ranges_with(std::size_t count, std::size_t grain, void (*job)(void*, std::size_t, std::size_t),
                         void* argument);

    std::unique_ptr<Impl> impl_;
};

/// Calls f(begin, end) for ranges of at most `grain` that cover [0, count), on the threads that the caller's
/// oneTBB arena has, and waits for all. f must not throw.
void for_ranges(std::size_t count, std::size_t grain, void (*f)(void*, std::size_t, std::size_t),
                void* argument);

namespace detail {

/// Calls f(i) for all i below `count` on the caller's threads. Of what is thrown, throws what the smallest i
/// threw, after all others have ended.
template <class F>
void for_each_in_parallel(std::size_t count, F&& f) {
    struct Run {
        F& f;
        std::mutex guard;
        std::size_t first_failed;
        std::exception_ptr error;
    };
    Run run{f, {}, count, {}};
    for_ranges(
        count, 1,
        [](void* argument, std::size_t begin, std::size_t end) {
            Run& mine = *static_cast<Run*>(argument);
            for (std::size_t i = begin; i < end; ++i) {
                try {
                    mine.f(i);
                } catch (...) {
                    const std::lock_guard lock{mine.guard};
                    if (i >= mine.first_failed) continue;
                    mine.first_failed = i;
                    mine.error = std::current_exception();
                }
            }
        },
        &run);
    if (run.error != nullptr) std::rethrow_exception(run.error);
}

}  // namespace detail

}  // namespace rambla::ecs
