#pragma once

#include "ecs/reflect.h"
#include "ecs/type_registry.h"
#include "property/ecs/parts.h"
#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {

template <>
struct reflection<test::Hidden> {
    static constexpr auto value = describe<test::Hidden>("hidden");
};
template <>
struct reflection<test::Selected> {
    static constexpr auto value = describe<test::Selected>("selected");
};
template <>
struct reflection<test::Light> {
    static constexpr auto value = describe<test::Light>("light").field("lux", &test::Light::lux);
};
template <>
struct reflection<test::Burning> {
    static constexpr auto value = describe<test::Burning>("burning").field("heat", &test::Burning::heat);
};
template <>
struct reflection<property::Quad> {
    static constexpr auto value = describe<property::Quad>("quad").field("values", &property::Quad::values);
};
template <>
struct reflection<test::Score> {
    static constexpr auto value = describe<test::Score>("score").field("points", &test::Score::points);
};

}  // namespace rambla::ecs

namespace rambla::ecs::property {

/// All parts: those that move by their own rules are not saved.
[[nodiscard]] inline TypeRegistry parts_registry() {
    TypeRegistry registry;
    registry.add<Health>();
    registry.add<Position>();
    registry.add<Byte>();
    registry.add<Frozen>();
    registry.add<Hidden>();
    registry.add<Parent>();
    registry.add<Light>();
    registry.add<Burning>();
    registry.add<Selected>();
    registry.add<Material>();
    registry.add<Tint>();
    registry.add<Score>();
    registry.add<Quad>();
    registry.add_transient<Anchored>("anchored");
    registry.add_transient<Owner>("owner");
    registry.add_transient<Line>("line");
    registry.add_transient<Ticket>("ticket");
    registry.add_transient<SparseAnchored>("sparse anchored");
    return registry;
}

}  // namespace rambla::ecs::property
