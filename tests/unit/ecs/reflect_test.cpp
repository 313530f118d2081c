#include "ecs/reflect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(Reflection, DescribesFieldsWithPlaceUnitAndRange) {
    const StructDescription& machine = description_of<Machine>();
    EXPECT_EQ(machine.name, "machine");
    EXPECT_EQ(machine.version, 3u);
    EXPECT_EQ(machine.size, sizeof(Machine));
    ASSERT_EQ(machine.fields.size(), 9u);

    const FieldDescription& hours = *machine.find("hours");
    EXPECT_EQ(hours.kind, FieldKind::float64);
    EXPECT_EQ(hours.offset, offsetof(Machine, hours));
    EXPECT_EQ(hours.options.unit, "h");
    EXPECT_EQ(hours.options.min, 0.0);

    const FieldDescription& gear = *machine.find("gear");
    EXPECT_EQ(gear.kind, FieldKind::uint8);
    ASSERT_EQ(gear.values.size(), 3u);
    EXPECT_EQ(name_of(gear, 7), "reverse");
    EXPECT_EQ(name_of(gear, 2), "");

    const FieldDescription& loads = *machine.find("loads");
    EXPECT_EQ(loads.count, 3u);
    EXPECT_EQ(loads.stride, sizeof(float));

    const FieldDescription& wheels = *machine.find("wheels");
    EXPECT_EQ(wheels.kind, FieldKind::structure);
    EXPECT_EQ(wheels.count, 2u);
    EXPECT_EQ(wheels.structure, &description_of<Velocity>());
    EXPECT_EQ(machine.find("engine"), nullptr);
    EXPECT_EQ(description_of<Frozen>().size, 0u) << "a tag";
}

TEST(Reflection, ReadsAndWritesFieldsWithoutTheirTypes) {
    const StructDescription& description = description_of<Machine>();
    Machine machine;
    const auto set = [&](std::string_view name, const FieldValue& value, std::uint32_t element = 0) {
        set_field(*description.find(name), &machine, value, element);
    };
    set("on", true);
    set("hours", 12.5);
    set("gear", std::uint64_t{7});
    set("slope", std::int64_t{-3});
    set("driver", Entity{4, 2});
    set("loads", 1.5, 2);
    set("serial", std::uint64_t{0xffffffffffffffffu});
    const FieldDescription& wheels = *description.find("wheels");
    set_field(*wheels.structure->find("y"), nested(wheels, &machine, 1), 9.0);

    const Machine expected{true,
                           12.5,
                           Gear::reverse,
                           -3,
                           Entity{4, 2},
                           {0, 0, 1.5f},
                           {},
                           {Velocity{}, {0, 9, 0}},
                           0xffffffffffffffffu};
    EXPECT_EQ(machine, expected);
    for (const FieldDescription& field : description.fields) {
        if (field.kind == FieldKind::structure) continue;
        Machine copy = machine;
        set_field(field, &copy, get_field(field, &machine));
        EXPECT_EQ(copy, machine) << field.name;
    }
    Label label{"over there", 3};
    EXPECT_EQ(std::get<std::string>(get_field(*description_of<Label>().find("text"), &label)), "over there");
}

TEST(Reflection, RefusesValuesThatAFieldCannotHold) {
    const StructDescription& description = description_of<Machine>();
    Machine machine;
    const auto set = [&](std::string_view name, const FieldValue& value, std::uint32_t element = 0) {
        set_field(*description.find(name), &machine, value, element);
    };
    EXPECT_THROW(set("hours", -1.0), Misuse) << "below its range";
    EXPECT_THROW(set("hours", std::nan("")), Misuse);
    EXPECT_THROW(set("hours", true), Misuse) << "another sort";
    EXPECT_THROW(set("gear", std::uint64_t{2}), Misuse) << "no such gear";
    EXPECT_THROW(set("gear", std::uint64_t{256}), Misuse) << "would wrap around to park";
    EXPECT_THROW(set("slope", std::int64_t{40000}), Misuse);
    EXPECT_THROW(set("loads", 1.0, 3), Misuse);
    EXPECT_THROW(set("place", 1.0), Misuse) << "a struct";
    EXPECT_EQ(machine, Machine{});
}

TEST(Reflection, DescribesElementsOfTypesWhoseMembersCannotBeNamed) {
    const FieldDescription& values = *description_of<Opaque>().find("values");
    EXPECT_EQ(values.count, 4u);
    EXPECT_EQ(values.options.unit, "lx");
    Opaque opaque;
    set_field(values, &opaque, 8.0, 3);
    EXPECT_EQ(opaque[3], 8.0f);
    EXPECT_EQ(std::get<double>(get_field(values, &opaque, 1)), 2.0);
}

TEST(TypeRegistry, FindsTypesByNameAndRefusesDoubledNames) {
    TypeRegistry registry = parts_registry();
    EXPECT_EQ(registry.component("health")->info, &component_info<Health>());
    EXPECT_EQ(registry.component(component_info<Label>())->name, "label");
    EXPECT_EQ(registry.component("rudder"), nullptr);
    EXPECT_TRUE(registry.component("cache")->transient());
    EXPECT_EQ(registry.resource("weather")->description, &description_of<Weather>());
    EXPECT_THROW(registry.add<Health>(), Misuse);
    EXPECT_THROW(registry.add_transient<Line>("health"), Misuse);
    EXPECT_THROW(registry.add_resource<Weather>(), Misuse);
}

}  // namespace
}  // namespace rambla::ecs
