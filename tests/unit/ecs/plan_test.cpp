#include "ecs/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ecs/misuse.h"
#include "ecs/schedule.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void reads_position(View<const Position>) {}
void writes_position(View<Position>) {}
void writes_velocity(View<Velocity>) {}
void moves(View<Position, const Velocity>) {}
void takes_all(World&) {}

std::vector<std::string> names(const Plan& plan) {
    std::vector<std::string> names;
    for (const PlannedSystem& system : plan.systems)
        names.push_back(system.name);
    return names;
}

/// "later<earlier" for each wait.
std::vector<std::string> waits(const Plan& plan) {
    std::vector<std::string> waits;
    for (const PlannedSystem& system : plan.systems) {
        for (const PlannedWait& wait : system.waits)
            waits.push_back(system.name + "<" + plan.systems[wait.system].name);
    }
    return waits;
}

std::string complaint(Schedule& schedule) {
    try {
        static_cast<void>(schedule.plan());
    } catch (const Misuse& misuse) {
        return misuse.what();
    }
    return {};
}

TEST(Plan, ConflictingSystemsWaitInTheOrderOfDeclarationAndOthersDoNot) {
    Schedule schedule;
    schedule.add("drag", writes_velocity);
    schedule.add("show", reads_position);
    schedule.add("move", moves);
    EXPECT_THAT(names(schedule.plan()), ElementsAre("drag", "show", "move"));
    EXPECT_THAT(waits(schedule.plan()), ElementsAre("move<drag", "move<show"));
}

TEST(Plan, AWaitNamesWhatBothTouch) {
    Schedule schedule;
    schedule.add("drag", writes_velocity);
    schedule.add("move", moves);
    const PlannedWait& wait = schedule.plan().systems[1].waits.at(0);
    ASSERT_EQ(wait.conflict.parts.size(), 1u);
    EXPECT_EQ(wait.conflict.parts[0].name, type_name<Velocity>());
    EXPECT_TRUE(wait.conflict.parts[0].writes);
    EXPECT_FALSE(wait.declared);
}

TEST(Plan, WaitsThatOthersImplyAreLeftOut) {
    Schedule schedule;
    schedule.add("a", writes_position);
    schedule.add("b", writes_position);
    schedule.add("c", writes_position);
    EXPECT_THAT(waits(schedule.plan()), ElementsAre("b<a", "c<b"));
    EXPECT_EQ(schedule.plan().ambiguities.size(), 3u) << "the pair a, c is ordered by declaration too";
}

TEST(Plan, BeforeAndAfterOverrideTheOrderOfDeclaration) {
    Schedule schedule;
    schedule.add("a", writes_position).after("c");
    schedule.add("b", reads_position);
    schedule.add("c", writes_position).before("b");
    EXPECT_THAT(names(schedule.plan()), ElementsAre("c", "a", "b"));
    EXPECT_THAT(waits(schedule.plan()), ElementsAre("a<c", "b<a"));
    ASSERT_EQ(schedule.plan().ambiguities.size(), 1u);
    EXPECT_EQ(schedule.plan().systems[schedule.plan().ambiguities[0].first].name, "a");
    EXPECT_EQ(schedule.plan().systems[schedule.plan().ambiguities[0].second].name, "b");
}

TEST(Plan, SystemsThatShareNothingCanStillBeOrdered) {
    Schedule schedule;
    schedule.add("a", writes_position).after("b");
    schedule.add("b", writes_velocity);
    EXPECT_THAT(waits(schedule.plan()), ElementsAre("a<b"));
    EXPECT_TRUE(schedule.plan().systems[1].waits[0].declared);
    EXPECT_TRUE(schedule.plan().ambiguities.empty());
}

TEST(Plan, AnOrderThatFollowsFromSeveralDeclarationsIsNotAmbiguous) {
    Schedule schedule;
    schedule.add("a", writes_position).before("b");
    schedule.add("b", writes_velocity).before("c");
    schedule.add("c", writes_position);
    EXPECT_TRUE(schedule.plan().ambiguities.empty());
}

TEST(Plan, ACycleIsRefusedAndNamed) {
    Schedule schedule;
    schedule.add("a", reads_position).before("b");
    schedule.add("b", reads_position).before("c");
    schedule.add("c", reads_position).before("a");
    schedule.add("d", reads_position);
    EXPECT_THAT(complaint(schedule), HasSubstr("\"a\" before \"b\" before \"c\" before \"a\""));
}

TEST(Plan, ASystemThatWaitsForItselfIsRefused) {
    Schedule schedule;
    schedule.add("a", reads_position).after("a");
    EXPECT_THAT(complaint(schedule), HasSubstr("\"a\" before \"a\""));
}

TEST(Plan, UnknownAndDoubleNamesAreRefused) {
    Schedule schedule;
    schedule.add("a", reads_position).after("nobody");
    EXPECT_THAT(complaint(schedule), HasSubstr("nobody"));
    EXPECT_THROW(schedule.add("a", moves), Misuse);
}

TEST(Plan, AnOrderAgainstTheStagesIsRefused) {
    Schedule schedule;
    schedule.add("a", reads_position).after("b");
    schedule.sync();
    schedule.add("b", reads_position);
    EXPECT_THAT(complaint(schedule), HasSubstr("\"b\" cannot run before \"a\""));
}

TEST(Plan, SystemsOfDifferentStagesNeedNotWaitForEachOther) {
    Schedule schedule;
    schedule.add("a", writes_position);
    schedule.sync();
    schedule.sync();
    schedule.add("b", writes_position).after("a");
    EXPECT_EQ(schedule.plan().stage_count, 2u) << "an empty stage is none";
    EXPECT_EQ(schedule.plan().systems[1].stage, 1u);
    EXPECT_THAT(waits(schedule.plan()), ElementsAre());
    EXPECT_TRUE(schedule.plan().ambiguities.empty());
}

TEST(Plan, TheWorldForItselfConflictsWithAll) {
    Schedule schedule;
    schedule.add("a", reads_position);
    schedule.add("all", takes_all);
    schedule.add("b", writes_velocity);
    EXPECT_THAT(waits(schedule.plan()), ElementsAre("all<a", "b<all"));
    EXPECT_TRUE(schedule.plan().systems[2].waits[0].conflict.exclusive);
}

TEST(Plan, AWorldBesideDeclaredAccessIsNotForItself) {
    Schedule schedule;
    schedule.add("declared", takes_all).reads<Velocity>().writes<Position>();
    schedule.add("query", [](World&, Query<const Velocity>&) {});
    const Plan& plan = schedule.plan();
    EXPECT_FALSE(plan.systems[0].access.everything());
    EXPECT_TRUE(plan.systems[0].access.covers(AccessKind::component, type_index<Position>(), true));
    EXPECT_FALSE(plan.systems[1].access.everything());
    EXPECT_THAT(waits(plan), ElementsAre());
}

TEST(Plan, ParametersDeclareTheirAccess) {
    Schedule schedule;
    schedule.add("all kinds",
                 [](View<Entity, Position, Optional<const Velocity>, With<Frozen>, Without<Hidden>>,
                    Lookup<const Byte>, Res<Line>, ResMut<Owner>, EventReader<Health>, EventWriter<Parent>&,
                    Commands&) {});
    const AccessSet& access = schedule.plan().systems[0].access;
    std::vector<std::string> parts;
    for (const AccessPart& part : access.parts()) {
        parts.push_back(std::string{part.writes ? "writes " : "reads "}
                            .append(to_string(part.kind))
                            .append(" ")
                            .append(short_name(part.name)));
    }
    EXPECT_THAT(parts, testing::UnorderedElementsAre("writes component Position", "reads component Velocity",
                                                     "reads component Byte", "reads resource Line",
                                                     "writes resource Owner", "reads resource Events<Health>",
                                                     "writes resource Events<Parent>"));
    EXPECT_TRUE(access.commands());
    EXPECT_FALSE(access.everything());
}

TEST(Plan, TextTellsStagesAccessWaitsAndAmbiguities) {
    Schedule schedule;
    schedule.add("drag", writes_velocity);
    schedule.add("move", moves);
    schedule.sync();
    schedule.add("reap", [](View<Entity, const Position>, Commands&) {});
    const std::string text = to_text(schedule.plan());
    EXPECT_EQ(text,
              "stage 1 of 2\n"
              "  drag\n"
              "    writes Velocity\n"
              "  move\n"
              "    reads  Velocity\n"
              "    writes Position\n"
              "    waits for drag: Velocity written before\n"
              "stage 2 of 2\n"
              "  reap\n"
              "    reads  Position\n"
              "    records structural changes\n"
              "ordered by declaration only\n"
              "  drag before move: Velocity written before\n");
}

TEST(Plan, ShortNamesHaveNoNamespaces) {
    EXPECT_EQ(short_name("a::b::C"), "C");
    EXPECT_EQ(short_name("a::C<b::D, e::F<3>, const g::H*>"), "C<D, F<3>, const H*>");
    EXPECT_EQ(short_name("a::(anonymous namespace)::C"), "C");
    EXPECT_EQ(short_name("a::{anonymous}::C"), "C");
    EXPECT_EQ(short_name("int"), "int");
}

}  // namespace
}  // namespace rambla::ecs::test
