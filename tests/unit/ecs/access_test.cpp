#include "ecs/access.h"

#include <gtest/gtest.h>

#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

AccessSet touching(std::initializer_list<AccessPart> parts) {
    AccessSet set;
    for (const AccessPart& part : parts)
        set.add(part);
    return set;
}

const AccessPart k_reads_position = access_part<Position>(AccessKind::component, false);
const AccessPart k_writes_position = access_part<Position>(AccessKind::component, true);
const AccessPart k_reads_velocity = access_part<Velocity>(AccessKind::component, false);

TEST(Access, TwoReadersDoNotConflict) {
    EXPECT_FALSE(conflict_between(touching({k_reads_position}), touching({k_reads_position})).any());
    EXPECT_FALSE(conflict_between(touching({k_writes_position}), touching({k_reads_velocity})).any());
}

TEST(Access, AWriterConflictsWithReaderAndWriterOfTheSameThing) {
    for (const AccessPart& other : {k_reads_position, k_writes_position}) {
        const Conflict conflict =
            conflict_between(touching({k_reads_velocity, k_writes_position}), touching({other}));
        ASSERT_EQ(conflict.parts.size(), 1u);
        EXPECT_EQ(conflict.parts[0].type_index, type_index<Position>());
        EXPECT_TRUE(conflict.parts[0].writes);
    }
}

TEST(Access, AComponentAndAResourceOfOneTypeAreTwoThings) {
    const AccessPart resource = access_part<Position>(AccessKind::resource, true);
    EXPECT_FALSE(conflict_between(touching({resource}), touching({k_writes_position})).any());
    EXPECT_TRUE(conflict_between(touching({resource}), touching({resource})).any());
}

TEST(Access, ReadingAndWritingOneThingCountsAsWriting) {
    const AccessSet set = touching({k_writes_position, k_reads_position});
    ASSERT_EQ(set.parts().size(), 1u);
    EXPECT_TRUE(set.covers(AccessKind::component, type_index<Position>(), true));
    EXPECT_FALSE(set.covers(AccessKind::component, type_index<Velocity>(), false));
    EXPECT_FALSE(set.covers(AccessKind::resource, type_index<Position>(), false));
}

TEST(Access, WhatIsReadIsNotCoveredForWriting) {
    const AccessSet set = touching({k_reads_position});
    EXPECT_TRUE(set.covers(AccessKind::component, type_index<Position>(), false));
    EXPECT_FALSE(set.covers(AccessKind::component, type_index<Position>(), true));
}

TEST(Access, EverythingConflictsEvenWithNothingAndCommandsWithNothing) {
    AccessSet everything;
    everything.add_everything();
    AccessSet commands;
    commands.add_commands();
    EXPECT_TRUE(conflict_between(everything, AccessSet{}).exclusive);
    EXPECT_TRUE(conflict_between(AccessSet{}, everything).exclusive);
    EXPECT_FALSE(conflict_between(commands, commands).any());
    EXPECT_TRUE(everything.covers(AccessKind::resource, type_index<Health>(), true));
}

}  // namespace
}  // namespace rambla::ecs::test
