#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ecs/query.h"
#include "ecs/reflect.h"
#include "ecs/reflect_parent.h"
#include "ecs/snapshot.h"
#include "ecs/type_registry.h"
#include "ecs/world_access.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {

enum class Gear : std::uint8_t { park, drive, reverse = 7 };

/// A component of every kind of field, with gaps between them.
struct Machine {
    bool on = false;
    double hours = 0.0;
    Gear gear = Gear::park;
    std::int16_t slope = 0;
    Entity driver;
    std::array<float, 3> loads{};
    Position place;
    std::array<Velocity, 2> wheels{};
    std::uint64_t serial = 0;
    bool operator==(const Machine&) const = default;
};

/// Owns memory.
struct Label {
    std::string text;
    std::uint32_t colour = 7;
    bool operator==(const Label&) const = default;
};

/// Lives in a sparse set.
struct Mark {
    std::string reason;
    bool operator==(const Mark&) const = default;
};
struct Chosen {};

/// Can be switched off row by row.
struct Engine {
    float power_w = 1.0f;
};

/// What is not worth keeping.
struct Cache {
    int value = -1;
};

/// A resource.
struct Weather {
    float wind_m_s = 0.0f;
    std::string name;
    bool operator==(const Weather&) const = default;
};

/// Another library's type, whose members cannot be named.
class Opaque {
public:
    [[nodiscard]] float& operator[](std::size_t i) { return values_[i]; }

private:
    float values_[4] = {1, 2, 3, 4};
};

/// All reflected parts.
inline TypeRegistry parts_registry();

}  // namespace rambla::ecs::test

namespace rambla::ecs {

template <>
struct component_options<test::Mark> {
    static constexpr Storage storage = Storage::sparse;
};
template <>
struct component_options<test::Chosen> {
    static constexpr Storage storage = Storage::sparse;
};
template <>
struct component_options<test::Engine> {
    static constexpr bool enable_bit = true;
};

template <>
struct reflection<test::Position> {
    static constexpr auto value = describe<test::Position>("position")
                                      .field("x", &test::Position::x, {.unit = "m", .min = -1e6, .max = 1e6})
                                      .field("y", &test::Position::y, {.unit = "m"})
                                      .field("z", &test::Position::z, {.unit = "m"});
};
template <>
struct reflection<test::Velocity> {
    static constexpr auto value = describe<test::Velocity>("velocity")
                                      .field("x", &test::Velocity::x, {.unit = "m/s"})
                                      .field("y", &test::Velocity::y, {.unit = "m/s"})
                                      .field("z", &test::Velocity::z, {.unit = "m/s"});
};
template <>
struct reflection<test::Health> {
    static constexpr auto value =
        describe<test::Health>("health").field("points", &test::Health::points, {.min = 0, .max = 100});
};
template <>
struct reflection<test::Byte> {
    static constexpr auto value = describe<test::Byte>("byte").field("value", &test::Byte::value);
};
template <>
struct reflection<test::Frozen> {
    static constexpr auto value = describe<test::Frozen>("frozen");
};
template <>
struct reflection<test::Gear> {
    static constexpr auto value = enumeration<test::Gear>(
        {{"park", test::Gear::park}, {"drive", test::Gear::drive}, {"reverse", test::Gear::reverse}});
};
template <>
struct reflection<test::Machine> {
    static constexpr auto value = describe<test::Machine>("machine", 3)
                                      .field("on", &test::Machine::on)
                                      .field("hours", &test::Machine::hours, {.unit = "h", .min = 0})
                                      .field("gear", &test::Machine::gear)
                                      .field("slope", &test::Machine::slope)
                                      .field("driver", &test::Machine::driver)
                                      .field("loads", &test::Machine::loads, {.unit = "N"})
                                      .field("place", &test::Machine::place)
                                      .field("wheels", &test::Machine::wheels)
                                      .field("serial", &test::Machine::serial);
};
template <>
struct reflection<test::Label> {
    static constexpr auto value = describe<test::Label>("label")
                                      .field("text", &test::Label::text)
                                      .field("colour", &test::Label::colour);
};
template <>
struct reflection<test::Mark> {
    static constexpr auto value = describe<test::Mark>("mark").field("reason", &test::Mark::reason);
};
template <>
struct reflection<test::Chosen> {
    static constexpr auto value = describe<test::Chosen>("chosen");
};
template <>
struct reflection<test::Engine> {
    static constexpr auto value =
        describe<test::Engine>("engine").field("power_w", &test::Engine::power_w, {.unit = "W"});
};
template <>
struct reflection<test::Material> {
    static constexpr auto value =
        describe<test::Material>("material").field("number", &test::Material::number);
};
template <>
struct reflection<test::Tint> {
    static constexpr auto value = describe<test::Tint>("tint")
                                      .field("kind", &test::Tint::kind)
                                      .field("strength", &test::Tint::strength);
};
template <>
struct reflection<test::Weather> {
    static constexpr auto value = describe<test::Weather>("weather")
                                      .field("wind_m_s", &test::Weather::wind_m_s)
                                      .field("name", &test::Weather::name);
};
template <>
struct reflection<test::Opaque> {
    static constexpr auto value = describe<test::Opaque>("opaque").elements<float>("values", {.unit = "lx"});
};

inline TypeRegistry test::parts_registry() {
    TypeRegistry registry;
    registry.add<Position>();
    registry.add<Velocity>();
    registry.add<Health>();
    registry.add<Byte>();
    registry.add<Parent>();
    registry.add<Frozen>();
    registry.add<Machine>();
    registry.add<Label>();
    registry.add<Mark>();
    registry.add<Chosen>();
    registry.add<Engine>();
    registry.add<Material>();
    registry.add<Tint>();
    registry.add_transient<Cache>("cache");
    registry.add_resource<Weather>();
    return registry;
}

}  // namespace rambla::ecs

namespace rambla::ecs::test {

using Bytes = std::vector<std::byte>;

inline Bytes copy_of(std::span<const std::byte> bytes) {
    return {bytes.begin(), bytes.end()};
}

/// Whether all that is in sparse sets is alive.
inline bool sparse_sets_are_sound(const World& world) {
    const SparseSets& sets = detail::WorldAccess::graph(world).sparse();
    return std::ranges::all_of(sets.all(), [&](const auto& set) {
        return std::ranges::all_of(set->entities(), [&](Entity entity) { return world.alive(entity); });
    });
}

/// A snapshot by a writer of its own.
inline Bytes snapshot_of(World& world, const TypeRegistry& registry) {
    SnapshotWriter writer{registry};
    return copy_of(writer.write(world));
}

}  // namespace rambla::ecs::test
