#include "ecs/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

template <class Run>
std::string complaint(const Run& run) {
    try {
        run();
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

/// Waits for `other` to come to the same point. False after some seconds: then they do not run side by side.
bool meet(std::atomic<int>& arrived) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{20};
    ++arrived;
    while (arrived < 2 && std::chrono::steady_clock::now() < deadline)
        std::this_thread::yield();
    return arrived >= 2;
}

TEST(Schedule, RunsFunctionsLambdasAndObjects) {
    struct Mover {
        float speed = 2.0f;
        void operator()(View<Position> moving) const {
            moving.each([this](Position& p) { p.x += speed; });
        }
    };
    World world;
    const Entity entity = world.create(Position{}, Velocity{1.0f});
    Schedule schedule;
    schedule.add("object", Mover{});
    schedule.add("lambda", [](View<Position, const Velocity> moving) {
        for (auto [positions, velocities] : moving.chunks())
            positions[0].x *= 10.0f + velocities[0].x;
    });
    void (*const function)(View<Position>) = [](View<Position> moving) {
        moving.each([](Position& p) { p.x += 1.0f; });
    };
    schedule.add("function", function);
    schedule.run(world);
    EXPECT_EQ(world.get<Position>(entity).x, 23.0f);
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

TEST(Schedule, ShortLoopsStayOnTheirThread) {
    World world;
    world.create(Position{});
    world.create(Position{}, Velocity{});
    Schedule schedule{{.threads = 2}};
    int wrong = 0;
    schedule.add("loop", [&](View<Position> all) {
        const auto self = std::this_thread::get_id();
        all.for_each_chunk([&](const auto&) { wrong += self == std::this_thread::get_id() ? 0 : 1; });
    });
    for (int run = 0; run < 50; ++run)
        schedule.run(world);
    EXPECT_EQ(wrong, 0);
}

TEST(Schedule, ChangesAreMadeAtTheEndOfTheStage) {
    World world;
    std::vector<std::size_t> seen;
    const auto look = [&](View<const Health> living) {
        seen.push_back(living.count());
    };
    Schedule schedule;
    schedule.add("spawn", [](Commands& commands) { commands.create(Health{1}); });
    schedule.add("same stage", look);
    schedule.sync();
    schedule.add("next stage", look).after("same stage");
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(0, 1));
    EXPECT_EQ(world.entity_count(), 1u);
}

TEST(Schedule, ASystemsOwnChangesComeBeforeThoseOfItsJobsAndOfLaterSystems) {
    World world;
    const Entity target = world.create(Position{});
    std::vector<float> seen;
    const auto look = [&] {
        seen.push_back(world.get<Velocity>(target).x);
    };
    Schedule schedule;
    schedule.add("a", [&](View<const Position> all, Commands& own, JobCommands& of_jobs) {
        all.for_each_chunk([&](const auto&, Job job) { of_jobs.of(job).add(target, Velocity{2.0f}); });
        own.add(target, Velocity{1.0f});
    });
    schedule.run(world);
    look();
    schedule.add("b", [&](Commands& own) { own.add(target, Velocity{3.0f}); });
    schedule.run(world);
    look();
    schedule.add("c", [&](Commands& own) { own.add(target, Velocity{4.0f}); }).before("a");
    schedule.run(world);
    look();
    EXPECT_THAT(seen, ElementsAre(2.0f, 3.0f, 3.0f));
}

TEST(Schedule, TheWorldForItselfAllowsStructuralChanges) {
    World world;
    Schedule schedule{{.threads = 2}};
    schedule.add("read", [](View<const Health>) {});
    schedule.add("all", [](World& all) { all.create(Health{}); });
    schedule.run(world);
    EXPECT_EQ(world.entity_count(), 1u);
}

TEST(Schedule, StructuralChangesInASystemThatSharesTheWorldAreRefused) {
    World world;
    Schedule schedule;
    schedule.add("sly", [](World& shared, Query<const Health>&) { shared.create(Health{}); });
    EXPECT_THAT(complaint([&] { schedule.run(world); }), AllOf(HasSubstr("\"sly\""), HasSubstr("create")));
    EXPECT_THROW(schedule.run(world), Misuse);
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST(Schedule, NewResourcesInASystemThatSharesTheWorldAreRefused) {
    World world;
    Schedule schedule;
    schedule.add("sly", [](World& shared, Query<const Health>&) { shared.set_resource(Byte{}); });
    EXPECT_THROW(schedule.run(world), Misuse);
    EXPECT_FALSE(world.has_resource<Byte>());
}

TEST(Schedule, AfterAnExceptionTheStageEndsAndLaterStagesDoNotRun) {
    for (const std::size_t threads : {1u, 4u}) {
        World world;
        world.set_resource(Health{});
        std::vector<std::string> ran;
        bool fail = true;
        Schedule schedule{{.threads = threads}};
        schedule.add("good", [&](ResMut<Health>, Commands& commands) {
            ran.push_back("good");
            commands.create(Position{});
        });
        schedule.add("bad", [&](ResMut<Health>) {
            ran.push_back("bad");
            if (fail) throw std::runtime_error{"out of ideas"};
        });
        schedule.add("worse", [&](ResMut<Health>) {
            ran.push_back("worse");
            if (fail) throw 3;
        });
        schedule.sync();
        schedule.add("later", [&](ResMut<Health>) { ran.push_back("later"); });
        EXPECT_THAT(complaint([&] { schedule.run(world); }),
                    AllOf(HasSubstr("\"bad\""), HasSubstr("out of ideas")));
        EXPECT_THAT(ran, ElementsAre("good", "bad", "worse"));
        EXPECT_EQ(world.entity_count(), 0u) << "recorded changes of the stage are dropped";
        EXPECT_THROW(schedule.run(world), SystemFailed) << "the schedule can run again";
        EXPECT_EQ(world.entity_count(), 0u);
        fail = false;
        schedule.run(world);
        EXPECT_EQ(world.entity_count(), 1u) << "of this run alone";
    }
}

TEST(Schedule, KeepsWhatASystemThrewNested) {
    World world;
    Schedule schedule;
    schedule.add("bad", [](View<const Position>) { throw std::out_of_range{"far"}; });
    try {
        schedule.run(world);
        FAIL();
    } catch (const SystemFailed& failed) {
        EXPECT_THROW(std::rethrow_if_nested(failed), std::out_of_range);
    }
}

TEST(Schedule, AllChunksGetTheirTurnAndTheFirstOnesExceptionIsThrown) {
    for (const std::size_t threads : {1u, 4u}) {
        World world;
        for (int i = 0; i < 16 * 1024; ++i)
            world.create(Health{i});
        std::atomic<int> turns{0};
        Schedule schedule{{.threads = threads}};
        schedule.add("loop", [&](View<const Health> all) {
            all.for_each_chunk([&](const auto& chunk) {
                ++turns;
                const int number = chunk.template get<0>()[0].points / 1024;
                if (number >= 5) throw std::runtime_error{"chunk " + std::to_string(number)};
            });
        });
        EXPECT_THAT(complaint([&] { schedule.run(world); }), HasSubstr("chunk 5"));
        EXPECT_EQ(turns, 16);
    }
}

TEST(Schedule, AMissingResourceNamesSystemAndResource) {
    World world;
    Schedule schedule;
    schedule.add("needy", [](Res<Health>) {});
    EXPECT_THAT(complaint([&] { schedule.run(world); }), AllOf(HasSubstr("\"needy\""), HasSubstr("Health")));
}

TEST(Schedule, EachRunBeginsANewVersion) {
    World world;
    Schedule schedule;
    schedule.add("nothing", [](View<const Position>) {});
    const std::uint32_t before = world.version();
    schedule.run(world);
    schedule.run(world);
    EXPECT_EQ(world.version(), before + 2);
}

TEST(Schedule, TimesAreToldInTheOrderOfThePlan) {
    World world;
    Schedule schedule;
    schedule.add("late", [](View<const Position>) {}).after("early");
    schedule.add("early",
                 [](View<const Position>) { std::this_thread::sleep_for(std::chrono::milliseconds{2}); });
    schedule.run(world);
    ASSERT_EQ(schedule.times().size(), 2u);
    EXPECT_EQ(schedule.times()[0].name, "early");
    EXPECT_GE(schedule.times()[0].ns, 2'000'000u);
}

TEST(Schedule, EightThreadsWorkEvenOnTwoCores) {
    World world;
    Schedule schedule{{.threads = 8}};
    schedule.add("nothing", [](View<const Position>) {});
    schedule.run(world);
    EXPECT_EQ(schedule.worker_threads(), 8u);
}

TEST(Schedule, SteadyRunsDoNotAllocate) {
    World world;
    for (int i = 0; i < 20'000; ++i)
        world.create(Position{}, Velocity{1.0f});
    Schedule schedule{{.threads = 2}};
    schedule.add("move", [](View<Position, const Velocity> moving) {
        moving.for_each_chunk(
            [](const auto& chunk) { chunk.each([](Position& p, const Velocity& v) { p.x += v.x; }); });
    });
    schedule.add("look", [](View<const Position> all) { static_cast<void>(all.count()); });
    for (int i = 0; i < 20; ++i)
        schedule.run(world);
    const std::size_t before = rambla::test::allocation_count();
    for (int i = 0; i < 100; ++i)
        schedule.run(world);
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

#if defined(RAMBLA_ASSERTS)

TEST(ScheduleAccess, UndeclaredReadsAndWritesAreNamed) {
    World world;
    const Entity entity = world.create(Position{}, Velocity{});
    world.set_resource(Health{});
    const auto complain = [&](auto system) {
        Schedule schedule{{.threads = 1}};
        schedule.add("sly", system);
        return complaint([&] { schedule.run(world); });
    };
    EXPECT_THAT(complain([&](View<const Velocity>) { static_cast<void>(world.get<Position>(entity)); }),
                AllOf(HasSubstr("\"sly\""), HasSubstr("reads component"), HasSubstr("Position")));
    EXPECT_THAT(complain([&](View<const Position>) { world.get_mut<Position>(entity).x = 1.0f; }),
                AllOf(HasSubstr("writes component"), HasSubstr("Position")));
    EXPECT_THAT(complain([&](View<const Position>) { static_cast<void>(world.resource<Health>()); }),
                AllOf(HasSubstr("writes resource"), HasSubstr("Health")));
    EXPECT_THAT(
        complain([&](View<const Position>) { static_cast<void>(std::as_const(world).resource<Health>()); }),
        AllOf(HasSubstr("reads resource"), HasSubstr("Health")));
    EXPECT_THAT(complain([&](View<const Position>) {
                    Query<const Position, Velocity> query;
                    query.each(world, [](const Position&, Velocity&) {});
                }),
                AllOf(HasSubstr("writes component"), HasSubstr("Velocity")));
    EXPECT_EQ(world.get<Position>(entity).x, 0.0f);
}

TEST(ScheduleAccess, DeclaredAccessIsAllowed) {
    World world;
    const Entity entity = world.create(Position{}, Velocity{3.0f});
    world.set_resource(Health{});
    Schedule schedule;
    schedule
        .add("honest",
             [&](World& shared, ResMut<Health>) {
                 shared.get_mut<Position>(entity).x = std::as_const(shared).get<Velocity>(entity).x;
                 shared.resource<Health>().points = 2;
             })
        .reads<Velocity>()
        .writes<Position>();
    schedule.add("lookup", [&](Lookup<const Position> of) { EXPECT_EQ(of.get<Position>(entity).x, 3.0f); });
    schedule.run(world);
    EXPECT_EQ(world.resource<Health>().points, 2);
}

TEST(ScheduleAccess, IsCheckedInJobsToo) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 8 * 1024; ++i)
        entities.push_back(world.create(Position{}, Velocity{}));
    for (const std::size_t threads : {1u, 4u}) {
        Schedule schedule{{.threads = threads}};
        schedule.add("sly", [&](View<const Position> all) {
            all.for_each_chunk([&](const auto&) { world.get_mut<Velocity>(entities[0]).x = 1.0f; });
        });
        EXPECT_THROW(schedule.run(world), Misuse);
    }
    EXPECT_EQ(world.get<Velocity>(entities[0]).x, 0.0f);
}

TEST(ScheduleAccess, OtherWorldsAndOtherTimesAreNotChecked) {
    World world;
    World other;
    const Entity entity = other.create(Position{});
    Schedule schedule;
    schedule.add("busy", [&](View<const Velocity>) { other.get_mut<Position>(entity).x = 1.0f; });
    schedule.run(world);
    EXPECT_EQ(other.get<Position>(entity).x, 1.0f);
    world.create(Health{});
}

TEST(ScheduleAccess, TwoSystemsThatBothWriteUndeclaredAreCaught) {
    World world;
    const Entity entity = world.create(Position{});
    Schedule schedule{{.threads = 2}};
    const auto write = [&](View<const Velocity>) {
        world.get_mut<Position>(entity).x += 1.0f;
    };
    schedule.add("first", write);
    schedule.add("second", write);
    EXPECT_TRUE(schedule.plan().ambiguities.empty()) << "by what they declare they do not conflict";
    EXPECT_THAT(complaint([&] { schedule.run(world); }), HasSubstr("\"first\""));
    EXPECT_EQ(world.get<Position>(entity).x, 0.0f);
}

#endif

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
