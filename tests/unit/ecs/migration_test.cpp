#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>

#include "ecs/snapshot.h"
#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {
namespace test {

/// How the component "tank" looked in three versions of a program.
struct Tank1 {
    float litres = 0.0f;
    std::int32_t colour = 0;
    std::string owner;
    Entity pump;
};
struct Tank2 {
    double pressure_pa = 101'325.0;  ///< new
    Entity pump;
    float litres = 0.0f;
    std::string owner;
};
struct Tank3 {
    double litres = 0.0;                ///< was float
    std::array<std::uint8_t, 3> rgb{};  ///< was one number
    std::string owner = "nobody";
    Entity pump;
};
/// As version 1, but with another field.
struct TankWithoutNotice {
    float cubic_metres = 0.0f;
};

}  // namespace test

template <>
struct reflection<test::Tank1> {
    static constexpr auto value = describe<test::Tank1>("tank", 1)
                                      .field("litres", &test::Tank1::litres)
                                      .field("colour", &test::Tank1::colour)
                                      .field("owner", &test::Tank1::owner)
                                      .field("pump", &test::Tank1::pump);
};
template <>
struct reflection<test::Tank2> {
    static constexpr auto value = describe<test::Tank2>("tank", 2)
                                      .field("pressure_pa", &test::Tank2::pressure_pa)
                                      .field("pump", &test::Tank2::pump)
                                      .field("litres", &test::Tank2::litres)
                                      .field("owner", &test::Tank2::owner);
};
template <>
struct reflection<test::Tank3> {
    static constexpr auto value = describe<test::Tank3>("tank", 3)
                                      .field("litres", &test::Tank3::litres)
                                      .field("rgb", &test::Tank3::rgb)
                                      .field("owner", &test::Tank3::owner)
                                      .field("pump", &test::Tank3::pump);
};
template <>
struct reflection<test::TankWithoutNotice> {
    static constexpr auto value =
        describe<test::TankWithoutNotice>("tank", 1).field("m3", &test::TankWithoutNotice::cubic_metres);
};

namespace {

using namespace test;

/// A registry with one version of the tank.
template <class Tank>
TypeRegistry registry_of() {
    TypeRegistry registry;
    registry.add<Tank>();
    registry.add<Health>();
    registry.add<Frozen>();
    return registry;
}

template <class Tank>
Bytes snapshot_with(const Tank& tank) {
    World world;
    world.create(tank, Health{5}, Frozen{});
    world.create(Health{6});
    world.create(tank, Health{7});
    return snapshot_of(world, registry_of<Tank>());
}

std::string message_of(const Bytes& bytes, const TypeRegistry& registry) {
    try {
        (void)read_snapshot(bytes, registry);
    } catch (const SnapshotError& error) {
        return error.what();
    }
    return "none";
}

const Tank1 k_old{12.5f, 0x010203, "Ada", {1, 1}};

TEST(Migration, MatchesFieldsByNameAndLeavesNewOnesAtTheirDefaults) {
    const RestoredWorld restored = read_snapshot(snapshot_with(k_old), registry_of<Tank2>());
    for (const Entity entity : {Entity{0, 1}, Entity{2, 1}}) {
        const Tank2& tank = restored.world->get<Tank2>(entity);
        EXPECT_EQ(tank.litres, 12.5f);
        EXPECT_EQ(tank.owner, "Ada");
        EXPECT_EQ(tank.pump, (Entity{1, 1}));
        EXPECT_EQ(tank.pressure_pa, 101'325.0);
    }
    EXPECT_EQ(restored.world->get<Health>({2, 1}).points, 7) << "what follows in the stream is where it was";
}

TEST(Migration, CallsWhatWasRegisteredForTheStoredVersion) {
    TypeRegistry registry = registry_of<Tank3>();
    registry.migrate<Tank3>(1, [](const StoredRow& stored, Tank3& tank) {
        EXPECT_EQ(stored.version(), 1u);
        EXPECT_EQ(tank.owner, "Ada") << "fields that match are there already";
        EXPECT_EQ(tank.litres, 0.0) << "a field of another kind is not";
        EXPECT_FALSE(stored.has("rgb"));
        tank.litres = stored.number("litres");
        const std::int64_t colour = stored.integer("colour");
        tank.rgb = {static_cast<std::uint8_t>(colour >> 16), static_cast<std::uint8_t>(colour >> 8),
                    static_cast<std::uint8_t>(colour)};
        EXPECT_EQ(stored.text("owner"), "Ada");
        EXPECT_EQ(stored.entity("pump"), (Entity{1, 1}));
        EXPECT_THROW((void)stored.number("rgb"), Misuse);
        EXPECT_THROW((void)stored.integer("litres"), Misuse);
        EXPECT_THROW((void)stored.text("colour"), Misuse);
        EXPECT_THROW((void)stored.number("litres", 1), Misuse);
    });
    const RestoredWorld restored = read_snapshot(snapshot_with(k_old), registry);
    const Tank3& tank = restored.world->get<Tank3>({2, 1});
    EXPECT_EQ(tank.litres, 12.5);
    EXPECT_EQ(tank.rgb, (std::array<std::uint8_t, 3>{1, 2, 3}));
    EXPECT_EQ(restored.world->get<Health>({2, 1}).points, 7);
}

TEST(Migration, RefusesAFieldOfAnotherKindThatNothingMigrates) {
    EXPECT_EQ(
        message_of(snapshot_with(k_old), registry_of<Tank3>()),
        "snapshot, byte 44: found tank version 1 (litres float32, colour int32, owner text, pump entity), "
        "expected tank version 3 (litres float64, rgb uint8[3], owner text, pump entity), or a migration "
        "from version 1");
}

TEST(Migration, RefusesNewerVersionsAndOtherFieldsUnderTheSameVersion) {
    EXPECT_NE(message_of(snapshot_with(Tank2{}), registry_of<Tank1>()).find("expected version 1 or older"),
              std::string::npos);
    EXPECT_NE(message_of(snapshot_with(k_old), registry_of<TankWithoutNotice>())
                  .find("expected tank version 1 (m3 float32)"),
              std::string::npos);
}

TEST(Migration, RefusesUnknownComponentsOrLeavesThemOut) {
    TypeRegistry without;
    without.add<Health>();
    without.add<Frozen>();
    const Bytes bytes = snapshot_with(k_old);
    EXPECT_EQ(message_of(bytes, without),
              "snapshot, byte 44: found component \"tank\", expected one that the registry knows");
    RestoredWorld restored = read_snapshot(bytes, without, {.world = {}, .drop_unknown_components = true});
    EXPECT_EQ(restored.dropped, std::vector<std::string>{"tank"});
    EXPECT_EQ(restored.world->get<Health>({0, 1}).points, 5);
    EXPECT_EQ(restored.world->get<Health>({1, 1}).points, 6);
    EXPECT_EQ(restored.world->get<Health>({2, 1}).points, 7);
    EXPECT_TRUE(restored.world->has<Frozen>({0, 1}));
    Query<Entity, With<Health>, Without<Frozen>> query;
    EXPECT_EQ(query.count(*restored.world), 2u) << "two archetypes of the snapshot are one now";
    EXPECT_EQ(restored.position, ChainPosition{}) << "no delta fits";
}

TEST(Migration, UpgradesDeltasToo) {
    World world;
    const Entity entity = world.create(k_old);
    const TypeRegistry old_registry = registry_of<Tank1>();
    SnapshotWriter writer{old_registry};
    const TypeRegistry registry = registry_of<Tank2>();
    RestoredWorld restored = read_snapshot(writer.write(world), registry);
    world.get_mut<Tank1>(entity).owner = "Grace";
    world.create(k_old);
    apply_delta(restored, writer.write_delta(world), registry);
    EXPECT_EQ(restored.world->get<Tank2>(entity).owner, "Grace");
    EXPECT_EQ(restored.world->get<Tank2>({1, 1}).litres, 12.5f);
}

}  // namespace
}  // namespace rambla::ecs
