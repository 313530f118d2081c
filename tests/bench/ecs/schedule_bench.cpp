#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <thread>
#include <vector>

#include "ecs/schedule.h"

namespace rambla::ecs {
namespace {

/// What trivial systems touch, one after the other.
struct Baton {
    std::uint64_t passes = 0;
};

/// Watches like threads do that expect an answer soon, but do not starve others for long.
template <class Done>
void watch(const Done& done) {
    for (int spins = 0; !done(); ++spins) {
        if (spins > 2000) std::this_thread::yield();
    }
}

/// Two threads hand a baton to and fro by an atomic that the other one watches.
void sync_bare(benchmark::State& state) {
    Baton baton;
    std::atomic<int> turn{0};
    std::thread other{[&] {
        for (;;) {
            watch([&] { return turn.load(std::memory_order_acquire) != 0; });
            if (turn.load(std::memory_order_acquire) < 0) return;
            ++baton.passes;
            turn.store(0, std::memory_order_release);
        }
    }};
    for (auto _ : state) {
        ++baton.passes;
        turn.store(1, std::memory_order_release);
        watch([&] { return turn.load(std::memory_order_acquire) == 0; });
    }
    turn.store(-1, std::memory_order_release);
    other.join();
    state.SetItemsProcessed(2 * state.iterations());
}

/// Two systems that depend on each other; a run passes from the first to the second and back.
void sync_rambla(benchmark::State& state) {
    World world;
    world.set_resource(Baton{});
    Schedule schedule{{.threads = 2}};
    schedule.add("to", [](ResMut<Baton> baton) { ++baton->passes; });
    schedule.add("fro", [](ResMut<Baton> baton) { ++baton->passes; }).after("to");
    for (auto _ : state)
        schedule.run(world);
    state.SetItemsProcessed(2 * state.iterations());
}

/// A job that ends only when another one has begun on another thread, so that both threads must come.
void meet(std::atomic<std::uint64_t>& arrived, std::uint64_t wanted) {
    arrived.fetch_add(1, std::memory_order_acq_rel);
    watch([&] { return arrived.load(std::memory_order_acquire) >= wanted; });
}

/// Two threads that wait for each other at every step.
void fork_join_bare(benchmark::State& state) {
    std::atomic<std::uint64_t> arrived{0};
    std::atomic<std::uint64_t> wanted{0};
    std::atomic<bool> ends{false};
    std::thread other{[&] {
        for (std::uint64_t seen = 0; !ends.load(std::memory_order_acquire);) {
            watch([&] { return wanted.load(std::memory_order_acquire) != seen; });
            seen = wanted.load(std::memory_order_acquire);
            arrived.fetch_add(1, std::memory_order_acq_rel);
        }
    }};
    std::uint64_t step = 0;
    for (auto _ : state) {
        step += 2;
        wanted.store(step, std::memory_order_release);
        meet(arrived, step);
    }
    ends.store(true, std::memory_order_release);
    wanted.store(step + 2, std::memory_order_release);
    other.join();
    state.SetItemsProcessed(state.iterations());
}

/// A loop of two jobs that both threads must take part in: a fork and a join.
void fork_join_rambla(benchmark::State& state) {
    Team team;
    team.resize(2);
    std::atomic<std::uint64_t> arrived{0};
    std::uint64_t step = 0;
    team.enter([&] {
        for (auto _ : state) {
            step += 2;
            team.for_ranges(2, 1, [&](std::size_t, std::size_t) { meet(arrived, step); });
        }
    });
    state.SetItemsProcessed(state.iterations());
}

BENCHMARK(sync_bare)->Name("sync/bare_2threads/2")->UseRealTime();
BENCHMARK(sync_rambla)->Name("sync/rambla_2threads/2")->UseRealTime();
BENCHMARK(fork_join_bare)->Name("fork_join/bare_2threads/2")->UseRealTime();
BENCHMARK(fork_join_rambla)->Name("fork_join/rambla_2threads/2")->UseRealTime();

/// Seven components: a body that moves, warms up and ages.
struct Position {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};
struct Velocity {
    float x = 1.0f, y = 2.0f, z = 3.0f;
};
struct Force {
    float x = 0.1f, y = 0.2f, z = 0.3f;
};
struct Mass {
    float kg = 2.0f;
};
struct Heat {
    float joule = 1.0f;
};
struct Age {
    float seconds = 0.0f;
};
struct Drag {
    float per_second = 0.1f;
};

void advance(std::span<Position> position, std::span<Velocity> velocity, std::span<const Force> force,
             std::span<const Mass> mass, std::span<Heat> heat, std::span<Age> age,
             std::span<const Drag> drag) {
    constexpr float k_step_s = 1.0f / 60.0f;
    for (std::size_t i = 0; i < position.size(); ++i) {
        const float push = k_step_s / mass[i].kg;
        const float keep = 1.0f - drag[i].per_second * k_step_s;
        velocity[i].x = (velocity[i].x + force[i].x * push) * keep;
        velocity[i].y = (velocity[i].y + force[i].y * push) * keep;
        velocity[i].z = (velocity[i].z + force[i].z * push) * keep;
        position[i].x += velocity[i].x * k_step_s;
        position[i].y += velocity[i].y * k_step_s;
        position[i].z += velocity[i].z * k_step_s;
        heat[i].joule += drag[i].per_second * mass[i].kg * k_step_s;
        age[i].seconds += k_step_s;
    }
}

void parallel_rambla(benchmark::State& state, std::size_t threads) {
    World world;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        world.create(Position{}, Velocity{}, Force{}, Mass{}, Heat{}, Age{}, Drag{});
    Schedule schedule{{.threads = threads}};
    schedule.add("advance", [](View<Position, Velocity, const Force, const Mass, Heat, Age, const Drag> all) {
        all.for_each_chunk([](const auto& chunk) {
            auto [position, velocity, force, mass, heat, age, drag] = chunk;
            advance(position, velocity, force, mass, heat, age, drag);
        });
    });
    for (auto _ : state)
        schedule.run(world);
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// The same as plain arrays.
struct Bodies {
    explicit Bodies(std::size_t rows)
        : position(rows), velocity(rows), force(rows), mass(rows), heat(rows), age(rows), drag(rows) {}

    void advance_rows(std::size_t first, std::size_t count) {
        const auto part = [&](auto& column) {
            return std::span{column}.subspan(first, count);
        };
        advance(part(position), part(velocity), part(force), part(mass), part(heat), part(age), part(drag));
    }

    std::vector<Position> position;
    std::vector<Velocity> velocity;
    std::vector<Force> force;
    std::vector<Mass> mass;
    std::vector<Heat> heat;
    std::vector<Age> age;
    std::vector<Drag> drag;
};

void parallel_bare(benchmark::State& state) {
    const auto rows = static_cast<std::size_t>(state.range(0));
    Bodies bodies{rows};
    for (auto _ : state) {
        bodies.advance_rows(0, rows);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// A second thread that watches for work without a pause, so that nothing has to be woken: the most that two
/// threads can gain here.
class SecondThread {
public:
    SecondThread()
        : thread_{[this] {
              serve();
          }} {}
    ~SecondThread() {
        work_ = nullptr;
        asked_.fetch_add(1, std::memory_order_release);
        thread_.join();
    }
    SecondThread(const SecondThread&) = delete;
    SecondThread& operator=(const SecondThread&) = delete;

    /// Runs f on both threads and waits for both.
    void run_twice(const std::function<void()>& f) {
        work_ = &f;
        const std::uint64_t round = asked_.fetch_add(1, std::memory_order_release) + 1;
        f();
        watch([&] { return answered_.load(std::memory_order_acquire) == round; });
    }

private:
    void serve() {
        for (std::uint64_t round = 1;; ++round) {
            watch([&] { return asked_.load(std::memory_order_acquire) >= round; });
            if (work_ == nullptr) return;
            (*work_)();
            answered_.store(round, std::memory_order_release);
        }
    }

    const std::function<void()>* work_ = nullptr;
    std::atomic<std::uint64_t> asked_{0};
    std::atomic<std::uint64_t> answered_{0};
    std::thread thread_;
};

void parallel_bare_2threads(benchmark::State& state) {
    const auto rows = static_cast<std::size_t>(state.range(0));
    const std::size_t block = rows / 16;
    Bodies bodies{rows};
    SecondThread second;
    for (auto _ : state) {
        std::atomic<std::size_t> next{0};
        second.run_twice([&] {
            for (std::size_t i; (i = next.fetch_add(block, std::memory_order_relaxed)) < rows;)
                bodies.advance_rows(i, std::min(block, rows - i));
        });
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// Keeps a core's units for arithmetic busy within the first-level cache.
void exercise(std::size_t rounds) {
    constexpr std::size_t k_lanes = 64;
    std::array<float, k_lanes> value{};
    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::size_t lane = 0; lane < k_lanes; ++lane)
            value[lane] = value[lane] * 0.999f + 0.5f;
        benchmark::DoNotOptimize(value);
    }
}

constexpr std::size_t k_rounds = 100'000;

void cores_bare(benchmark::State& state) {
    for (auto _ : state)
        exercise(k_rounds);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(k_rounds));
}

/// What two of this machine's processors are worth: half the time where each is a core of its own, hardly
/// less than one takes where both are threads of one core, or are lent out.
void cores_rambla_2threads(benchmark::State& state) {
    Team team;
    team.resize(2);
    team.enter([&] {
        for (auto _ : state)
            team.for_ranges(k_rounds, k_rounds / 16,
                            [](std::size_t begin, std::size_t end) { exercise(end - begin); });
    });
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(k_rounds));
}

BENCHMARK(cores_bare)->Name("cores/bare/2")->UseRealTime();
BENCHMARK(cores_rambla_2threads)->Name("cores/rambla_2threads/2")->UseRealTime();
BENCHMARK(parallel_bare)->Name("parallel/bare")->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->UseRealTime();
BENCHMARK(parallel_bare_2threads)
    ->Name("parallel/bare_2threads")
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->UseRealTime();
BENCHMARK_CAPTURE(parallel_rambla, one, std::size_t{1})
    ->Name("parallel/rambla")
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->UseRealTime();
BENCHMARK_CAPTURE(parallel_rambla, two, std::size_t{2})
    ->Name("parallel/rambla_2threads")
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->UseRealTime();

}  // namespace
}  // namespace rambla::ecs
