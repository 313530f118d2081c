#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <span>
#include <thread>
#include <vector>

#include "ecs/schedule.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

/// Waits for `other` to come to the same point. False after some seconds: then they do not run side by side.
bool meet(std::atomic<int>& arrived) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{20};
    ++arrived;
    while (arrived < 2 && std::chrono::steady_clock::now() < deadline)
        std::this_thread::yield();
    return arrived >= 2;
}

TEST(Schedule, SystemsWithoutConflictRunSideBySide) {
    World world;
    std::atomic<int> arrived{0};
    Schedule schedule{{.threads = 2}};
    schedule.add("a", [&](View<Position>) { EXPECT_TRUE(meet(arrived)); });
    schedule.add("b", [&](View<Velocity>) { EXPECT_TRUE(meet(arrived)); });
    schedule.run(world);
}

/// Undefined behaviour on purpose: run under the thread sanitizer alone (tests/CMakeLists.txt), which must
/// see it, or else its silence about the other tests means nothing.
TEST(Schedule, DISABLED_SystemsThatRace) {
    World world;
    std::atomic<int> arrived{0};
    int shared = 0;
    const auto race = [&] {
        arrived.fetch_add(1, std::memory_order_relaxed);  // relaxed: orders nothing, hides nothing
        while (arrived.load(std::memory_order_relaxed) < 2)
            std::this_thread::yield();
        ++shared;
    };
    Schedule schedule{{.threads = 2}};
    schedule.add("a", [&](View<Position>) { race(); });
    schedule.add("b", [&](View<Velocity>) { race(); });
    schedule.run(world);
    EXPECT_EQ(shared, 2);
}

TEST(Schedule, ConflictingSystemsDoNot) {
    World world;
    world.set_resource(Health{});
    std::atomic<int> inside{0};
    Schedule schedule{{.threads = 4}};
    for (int i = 0; i < 6; ++i) {
        schedule.add("writer " + std::to_string(i), [&, i](ResMut<Health> health) {
            EXPECT_EQ(inside++, 0);
            EXPECT_EQ(health->points % 6, i);
            ++health->points;
            std::this_thread::yield();
            --inside;
        });
    }
    for (int run = 0; run < 200; ++run)
        schedule.run(world);
    EXPECT_EQ(world.resource<Health>().points, 1200);
}

TEST(Schedule, ChunksOfALongLoopAreSharedByThreads) {
    World world;
    for (int i = 0; i < 2 * 1024; ++i)
        world.create(Position{});
    std::atomic<int> arrived{0};
    Schedule schedule{{.threads = 2}};
    schedule.add("loop", [&](View<Position> all) {
        all.for_each_chunk([&](const auto&) { EXPECT_TRUE(meet(arrived)); });
    });
    schedule.run(world);
}

// Whether later runs are shared depends on how long the earlier ones took (LoopCost), the first on rows
// alone.
TEST(Schedule, AShortLoopStaysOnItsThread) {
    World world;
    world.create(Position{});
    world.create(Position{}, Velocity{});
    std::atomic<int> elsewhere{0};
    std::atomic<int> chunks{0};
    for (int run = 0; run < 50; ++run) {
        Schedule schedule{{.threads = 2}};
        schedule.add("loop", [&](View<Position> all) {
            const auto self = std::this_thread::get_id();
            all.for_each_chunk([&](const auto&) {
                ++chunks;
                if (self != std::this_thread::get_id()) ++elsewhere;
            });
        });
        schedule.run(world);
    }
    EXPECT_EQ(chunks, 100);
    EXPECT_EQ(elsewhere, 0);
}

TEST(Schedule, EightThreadsWorkEvenOnTwoCores) {
    World world;
    Schedule schedule{{.threads = 8}};
    schedule.add("nothing", [](View<const Position>) {});
    schedule.run(world);
    EXPECT_EQ(schedule.worker_threads(), 8u);
}

/// Particles that are born, move, age and die, in systems that share chunks and record changes in jobs.
class Fountain {
public:
    struct Age {
        std::uint32_t steps = 0;
    };
    struct Born {
        std::uint32_t count = 0;
    };
    struct Died {
        Entity entity;
        std::uint32_t age = 0;
    };
    struct Toll {
        std::uint64_t hash = 0;
    };

    explicit Fountain(std::size_t threads) : schedule_{{.threads = threads}} {
        world_.set_resource(Born{});
        world_.set_resource(Toll{});
        for (std::uint32_t i = 0; i < 9000; ++i)
            world_.create(Position{static_cast<float>(i)}, Velocity{1.0f, 0.5f}, Age{i % 97});
        schedule_.add("move", [](View<Position, const Velocity> all) {
            all.for_each_chunk([](const auto& chunk) {
                chunk.each([](Position& p, const Velocity& v) {
                    p.x += v.x * 0.25f;
                    p.y = p.y * 0.99f + v.y;
                });
            });
        });
        schedule_.add("age", [](View<Entity, Age> all, JobCommands& commands, EventWriter<Died>& died) {
            all.for_each_chunk([&](const auto& chunk, Job job) {
                chunk.each([&](Entity entity, Age& age) {
                    if (++age.steps < 90 + entity.index % 13) return;
                    commands.of(job).destroy(entity);
                    died.emit(job, {entity, age.steps});
                });
            });
        });
        schedule_.add("freeze", [](View<Entity, const Position, Without<Frozen>> all, JobCommands& commands) {
            all.for_each_chunk([&](const auto& chunk, Job job) {
                chunk.each([&](Entity entity, const Position& p) {
                    if (static_cast<int>(p.x) % 50 == 7) commands.of(job).template add<Frozen>(entity);
                });
            });
        });
        schedule_.add("toll", [](EventReader<Died> died, ResMut<Toll> toll) {
            died.each([&](const Died& one) { toll->hash = toll->hash * 31 + one.entity.index + one.age; });
        });
        schedule_.sync();
        schedule_.add("spawn", [](ResMut<Born> born, EventReader<Died> died, Commands& commands) {
            died.each([&](const Died& one) {
                ++born->count;
                commands.create(Position{static_cast<float>(born->count % 1000)},
                                Velocity{static_cast<float>(one.age % 7), 1.0f}, Age{});
            });
        });
    }

    void run(int steps) {
        for (int i = 0; i < steps; ++i)
            schedule_.run(world_);
    }

    /// Every byte of every column, in the order of the rows.
    [[nodiscard]] std::vector<std::byte> bytes() {
        std::vector<std::byte> bytes;
        const auto append = [&](const auto& span) {
            const auto part = std::as_bytes(span);
            bytes.insert(bytes.end(), part.begin(), part.end());
        };
        Query<Entity, const Position, const Velocity, const Age> all;
        for (auto [entities, positions, velocities, ages] : all.chunks(std::as_const(world_))) {
            append(entities);
            append(positions);
            append(velocities);
            append(ages);
        }
        append(std::span{&world_.resource<Toll>(), 1});
        append(std::span{&world_.resource<Born>(), 1});
        return bytes;
    }
    [[nodiscard]] std::uint32_t born() { return world_.resource<Born>().count; }

private:
    World world_;
    Schedule schedule_;
};

TEST(Schedule, LeavesTheSameBytesForAnyNumberOfThreads) {
    constexpr int k_steps = 400;
    Fountain alone{1};
    alone.run(k_steps);
    const std::vector<std::byte> expected = alone.bytes();
    EXPECT_GT(alone.born(), 20'000u);
    for (std::size_t threads = 2; threads <= 8; ++threads) {
        Fountain together{threads};
        together.run(k_steps);
        EXPECT_TRUE(together.bytes() == expected) << "with " << threads << " threads";
    }
}

}  // namespace
}  // namespace rambla::ecs::test
