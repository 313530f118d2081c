#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "ecs/schedule.h"
#include "unit/ecs/complaint.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ScheduleAccess, StructuralChangesInASystemThatSharesTheWorldAreRefused) {
    World world;
    Schedule schedule;
    schedule.add("sly", [](World& shared, Query<const Health>&) { shared.create(Health{}); });
    EXPECT_THAT(complaint([&] { schedule.run(world); }), AllOf(HasSubstr("\"sly\""), HasSubstr("create")));
    EXPECT_THROW(schedule.run(world), Misuse);
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST(ScheduleAccess, NewResourcesInASystemThatSharesTheWorldAreRefused) {
    World world;
    Schedule schedule;
    schedule.add("sly", [](World& shared, Query<const Health>&) { shared.set_resource(Byte{}); });
    EXPECT_THROW(schedule.run(world), Misuse);
    EXPECT_FALSE(world.has_resource<Byte>());
}

TEST(ScheduleAccess, EndingTheVersionInASystemThatSharesTheWorldIsRefused) {
    World world;
    const std::uint32_t before = world.version();
    Schedule schedule;
    schedule.add("sly", [](World& shared, Query<const Health>&) { shared.advance_version(); });
    EXPECT_THAT(complaint([&] { schedule.run(world); }),
                AllOf(HasSubstr("\"sly\""), HasSubstr("calls advance_version")));
    EXPECT_EQ(world.version(), before + 1) << "of the run alone";
    Schedule alone;
    alone.add("honest", [](World& all) { all.advance_version(); });
    alone.run(world);
    EXPECT_EQ(world.version(), before + 3) << "of the run, and of the system that has the world for itself";
}

TEST(ScheduleAccess, OfAComponentOrdersWhoSwitchesItAndWhoAsks) {
    const auto waits = [](auto declare) {
        Schedule schedule;
        declare(schedule.add("switch", [](World&) {}));
        schedule.add("lit", [](View<Enabled<Light>>) {});
        return schedule.plan().systems[1].waits.size();
    };
    EXPECT_EQ(waits([](Schedule::Added added) { added.writes<Light>(); }), 1u);
    EXPECT_EQ(waits([](Schedule::Added added) { added.writes<EnableState<Light>>(); }), 1u);
    EXPECT_EQ(waits([](Schedule::Added added) { added.reads<Light>(); }), 0u);
    EXPECT_EQ(waits([](Schedule::Added added) { added.writes_resources<Light>(); }), 0u);
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

TEST(ScheduleAccess, WhoDeclaresAComponentMayUseItsEnableBits) {
    World world;
    const Entity entity = world.create(Light{1.0f});
    Schedule schedule;
    schedule.add("switch", [&](World& shared) { shared.set_enabled<Light>(entity, false); }).writes<Light>();
    bool enabled = true;
    schedule.add("look", [&](World& shared) { enabled = shared.enabled<Light>(entity); }).reads<Light>();
    schedule.run(world);
    EXPECT_FALSE(enabled);
    const auto complain = [&](auto declare) {
        Schedule sly;
        declare(sly.add("sly", [&](World& shared) { shared.set_enabled<Light>(entity, true); }));
        return complaint([&] { sly.run(world); });
    };
    const auto names = AllOf(HasSubstr("\"sly\""), HasSubstr("writes component"), HasSubstr("EnableState"),
                             HasSubstr("Light"));
    EXPECT_THAT(complain([](Schedule::Added added) { added.reads<Light>(); }), names);
    EXPECT_THAT(complain([](Schedule::Added added) { added.writes<Position>(); }), names);
    EXPECT_THAT(complain([](Schedule::Added added) { added.writes_resources<Light>(); }), names);
    EXPECT_FALSE(world.enabled<Light>(entity));
    EXPECT_EQ(complain([](Schedule::Added added) { added.writes<EnableState<Light>>(); }), "");
    EXPECT_TRUE(world.enabled<Light>(entity));
}

#endif

}  // namespace
}  // namespace rambla::ecs::test
