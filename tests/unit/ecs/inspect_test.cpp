#include "ecs/inspect.h"

#include <gtest/gtest.h>

#include "ecs/misuse.h"
#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

std::vector<std::string> names_of(const World& world, const TypeRegistry& registry, Entity entity) {
    std::vector<std::string> names;
    for (const InspectedComponent& component : components_of(world, registry, entity))
        names.emplace_back(component.type->name);
    return names;
}

TEST(Inspect, FindsComponentsOfEveryStorage) {
    World world;
    const TypeRegistry registry = parts_registry();
    const Entity entity = world.create(Position{1, 2, 3}, Frozen{}, Mark{"why"}, Chosen{}, Engine{});
    const std::vector<InspectedComponent> found = components_of(world, registry, entity);
    int values = 0;
    for (const InspectedComponent& component : found) {
        const std::string_view name = component.type->name;
        if (name == "position") {
            EXPECT_EQ(component.value, &world.get<Position>(entity));
            EXPECT_TRUE(component.writable);
            ++values;
        } else if (name == "mark") {
            EXPECT_EQ(component.value, &world.get<Mark>(entity));
            EXPECT_TRUE(component.writable);
            ++values;
        } else if (name == "frozen" || name == "chosen") {
            EXPECT_EQ(component.value, nullptr);
            EXPECT_FALSE(component.writable);
        } else if (name == "engine.disabled") {
            EXPECT_FALSE(component.writable) << "enable bits have summaries";
        } else {
            EXPECT_EQ(name, "engine");
        }
    }
    EXPECT_EQ(values, 2);
    EXPECT_EQ(found.size(), 6u);
    EXPECT_TRUE(names_of(world, registry, world.create()).empty());
}

TEST(Inspect, WritingCountsAsAChange) {
    World world;
    const TypeRegistry registry = parts_registry();
    const Entity entity = world.create(Position{1, 2, 3}, Mark{"why"});
    const std::uint32_t seen = world.advance_version();
    const auto changed = [&] {
        return Query<Changed<Position>>{}.count(world, {seen});
    };
    EXPECT_EQ(changed(), 0u);
    void* const value = component_for_writing(world, *registry.component("position"), entity);
    ASSERT_EQ(value, &world.get<Position>(entity));
    set_field(*description_of<Position>().find("y"), value, 7.0);
    EXPECT_EQ(world.get<Position>(entity).y, 7.0f);
    EXPECT_EQ(changed(), 1u);
    EXPECT_EQ(component_for_writing(world, *registry.component("mark"), entity), &world.get<Mark>(entity));
    EXPECT_EQ(component_for_writing(world, *registry.component("velocity"), entity), nullptr);
    EXPECT_EQ(component_for_writing(world, *registry.component("frozen"), entity), nullptr);
}

TEST(Inspect, ArchetypesCountAsInTheirStatistics) {
    World world;
    const Entity first = world.create(Position{});
    const Entity second = world.create(Position{});
    world.create(Position{}, Velocity{});
    const std::vector<ArchetypeStats> stats = world.archetype_stats();
    std::size_t entities = 0;
    for (std::size_t i = 0; i < stats.size(); ++i) {
        const std::span<const Entity> rows = entities_of_archetype(world, i);
        EXPECT_EQ(rows.size(), stats[i].rows);
        entities += rows.size();
        if (rows.size() == 2) {
            EXPECT_EQ(rows[0], first);
            EXPECT_EQ(rows[1], second);
        }
    }
    EXPECT_EQ(entities, 3u);
    EXPECT_THROW(static_cast<void>(entities_of_archetype(world, stats.size())), Misuse);
}

TEST(Inspect, StaleHandlesAreMisuse) {
    World world;
    const TypeRegistry registry = parts_registry();
    const Entity entity = world.create(Position{});
    world.destroy(entity);
    EXPECT_THROW(static_cast<void>(components_of(world, registry, entity)), Misuse);
    EXPECT_THROW(static_cast<void>(component_for_writing(world, *registry.component("position"), entity)),
                 Misuse);
}

}  // namespace
}  // namespace rambla::ecs
