#include "ecs/world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ecs/query.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// All bytes tell which entity they belong to.
template <std::size_t Size>
struct Bytes {
    explicit Bytes(int number) {
        for (std::size_t i = 0; i < Size; ++i)
            values[i] = static_cast<std::uint8_t>(number * 7 + static_cast<int>(i));
    }
    bool operator==(const Bytes&) const = default;

    std::array<std::uint8_t, Size> values;
};

template <std::size_t Size>
void expect_bytes(World& world, Entity entity, int number) {
    EXPECT_EQ(world.get<Bytes<Size>>(entity), Bytes<Size>{number}) << "of " << Size;
}

template <std::size_t... Sizes>
void expect_destroy_keeps_bytes() {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 10; ++i)
        entities.push_back(world.create(Bytes<Sizes>{i}...));
    for (int i : {0, 9, 4, 5})
        world.destroy(entities[static_cast<std::size_t>(i)]);
    for (int i : {1, 2, 3, 6, 7, 8})
        (expect_bytes<Sizes>(world, entities[static_cast<std::size_t>(i)], i), ...);
}

/// Knows where it is, and has nothing to end.
struct Selfish {
    Selfish() = default;
    Selfish(Selfish&&) noexcept {}

    const Selfish* self = this;
};
/// Has something to end, and moves by its bytes.
struct Keeper {
    std::shared_ptr<int> kept;
};

}  // namespace

template <>
struct is_relocatable<Keeper> : std::true_type {};

namespace {

template <class Error, class F>
std::string message_of(F&& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(World, KeepsTheComponentsOfAnEntity) {
    World world;
    const Entity a = world.create(Position{1, 2, 3}, Health{5});
    const Entity b = world.create();
    world.add(b, Velocity{4, 5, 6});
    EXPECT_EQ(world.get<Position>(a), (Position{1, 2, 3}));
    EXPECT_EQ(world.get<Health>(a).points, 5);
    EXPECT_EQ(world.get<Velocity>(b), (Velocity{4, 5, 6}));
    EXPECT_TRUE(world.has<Health>(a));
    EXPECT_FALSE(world.has<Health>(b));
    EXPECT_EQ(world.try_get<Velocity>(a), nullptr);
    EXPECT_EQ(world.entity_count(), 2u);
}

TEST(World, CreateLandsDirectlyInTheFinalArchetype) {
    World world;
    world.create(Position{}, Velocity{}, Health{});
    EXPECT_EQ(world.archetype_count(), 2u) << "the empty one and the final one";
    world.create(Health{}, Position{}, Velocity{});
    EXPECT_EQ(world.archetype_count(), 2u) << "the order of the components does not matter";
}

TEST(World, AddMovesAndReplacesWithoutTouchingTheRest) {
    World world;
    const Entity entity = world.create(Position{1, 2, 3});
    world.add(entity, Anchored{7});
    world.add(entity, Frozen{});
    world.add<Hidden>(entity);
    EXPECT_EQ(world.get<Position>(entity), (Position{1, 2, 3}));
    EXPECT_TRUE(world.get<Anchored>(entity).intact());
    world.add(entity, Anchored{8});
    EXPECT_EQ(world.get<Anchored>(entity).number(), 8);
    EXPECT_EQ(Anchored::alive, 1) << "the replaced one ended";
    world.remove<Anchored>(entity);
    EXPECT_EQ(Anchored::alive, 0);
    EXPECT_TRUE(world.has<Frozen>(entity));
    EXPECT_TRUE(world.has<Hidden>(entity));
    world.remove<Frozen>(entity);
    EXPECT_FALSE(world.has<Frozen>(entity));
}

TEST(World, DestroyKeepsTheOthersReachable) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 10; ++i)
        entities.push_back(world.create(Health{i}, Anchored{i}));
    for (int i : {0, 9, 4, 5})
        world.destroy(entities[static_cast<std::size_t>(i)]);
    for (int i : {1, 2, 3, 6, 7, 8}) {
        const Entity entity = entities[static_cast<std::size_t>(i)];
        EXPECT_EQ(world.get<Health>(entity).points, i);
        EXPECT_EQ(world.get<Anchored>(entity).number(), i);
        EXPECT_TRUE(world.get<Anchored>(entity).intact());
    }
    EXPECT_EQ(Anchored::alive, 6);
}

TEST(World, DestroyKeepsEveryByteOfTheOthersWhateverTheSizes) {
    expect_destroy_keeps_bytes<1, 2, 3, 4, 5, 7, 8, 9, 12, 15, 16, 17, 24, 31, 32>();
    expect_destroy_keeps_bytes<12, 33, 64, 100>();
}

TEST(World, DestroyMovesTheLastRowAsItsTypeWants) {
    World world;
    const Entity first = world.create(Selfish{});
    const Entity last = world.create(Selfish{});
    world.destroy(first);
    EXPECT_EQ(world.get<Selfish>(last).self, &world.get<Selfish>(last));
}

TEST(World, DestroyEndsWhatMovesByItsBytes) {
    World world;
    const auto shared = std::make_shared<int>(0);
    const Entity first = world.create(Keeper{shared});
    const Entity last = world.create(Keeper{shared});
    world.destroy(first);
    EXPECT_EQ(shared.use_count(), 2);
    world.destroy(last);
    EXPECT_EQ(shared.use_count(), 1);
}

TEST(World, EndsAllComponentsWithItself) {
    {
        World world;
        for (int i = 0; i < 3000; ++i)
            world.create(Anchored{i}, Owner{std::make_unique<int>(i)});
        EXPECT_EQ(Anchored::alive, 3000);
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(World, GrowthNeverMovesRowsOnceTheColumnsAreReserved) {
    if (!ReservedMemory::grows_in_place) GTEST_SKIP() << "this system cannot";
    World world;
    const Entity first = world.create(Position{1, 2, 3}, Anchored{1});
    for (std::uint32_t i = 0; i < k_pooled_rows; ++i)
        world.create(Position{}, Anchored{});
    const Position* position = &world.get<Position>(first);
    const Anchored* anchored = &world.get<Anchored>(first);
    for (int i = 0; i < 200'000; ++i)
        world.create(Position{}, Anchored{});
    EXPECT_EQ(&world.get<Position>(first), position);
    EXPECT_EQ(&world.get<Anchored>(first), anchored);
    EXPECT_TRUE(anchored->intact());
}

TEST(World, GrowingOutOfThePoolKeepsEveryValue) {
    for (bool reserves : {true, false}) {
        World world{{.reserve_address_space = reserves}};
        std::vector<Entity> entities;
        for (int i = 0; i < 5000; ++i) {
            entities.push_back(world.create(Health{i}, Anchored{i}, Owner{std::make_unique<int>(i)}));
        }
        for (int i = 0; i < 5000; ++i) {
            const Entity entity = entities[static_cast<std::size_t>(i)];
            ASSERT_EQ(world.get<Health>(entity).points, i);
            ASSERT_TRUE(world.get<Anchored>(entity).intact());
            ASSERT_EQ(*world.get<Owner>(entity).value, i);
        }
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(World, ColumnsBeginAtCacheLinesInPoolAndReservation) {
    World world;
    Query<Entity, const Position, const Byte, const Line> query;
    for (int i = 0; i < 3000; ++i) {
        world.create(Position{}, Byte{}, Line{});
        if (i % 50 != 0) continue;
        for (auto [entities, positions, bytes, lines] : query.chunks(world)) {
            for (const void* first :
                 {static_cast<const void*>(entities.data()), static_cast<const void*>(positions.data()),
                  static_cast<const void*>(bytes.data()), static_cast<const void*>(lines.data())}) {
                ASSERT_EQ(reinterpret_cast<std::uintptr_t>(first) % k_column_alignment, 0u);
            }
        }
    }
}

TEST(World, MisuseNamesTheCallTheComponentAndTheEntity) {
    World world;
    const Entity entity = world.create(Position{});
    const Entity dead = world.create();
    world.destroy(dead);
    using testing::AllOf;
    using testing::HasSubstr;
    EXPECT_THAT(
        message_of<Misuse>([&] { (void)world.get<Velocity>(entity); }),
        AllOf(HasSubstr("get<"), HasSubstr("Velocity"), HasSubstr("0v1"), HasSubstr("no such component")));
    EXPECT_THAT(message_of<Misuse>([&] { (void)world.get_mut<Velocity>(entity); }),
                AllOf(HasSubstr("get_mut<"), HasSubstr("Velocity"), HasSubstr("0v1")));
    EXPECT_THAT(message_of<Misuse>([&] { (void)world.get<Position>(dead); }),
                AllOf(HasSubstr("get<"), HasSubstr("Position"), HasSubstr("1v1"), HasSubstr("not alive")));
    EXPECT_THAT(message_of<Misuse>([&] { (void)world.resource<Health>(); }), HasSubstr("Health"));
}

TEST(World, EveryCallChecksItsHandle) {
    World world;
    const Entity dead = world.create(Position{});
    world.destroy(dead);
    for (const Entity bad : {dead, Entity{}, Entity{0, 0}, Entity{7, 1}}) {
        EXPECT_FALSE(world.alive(bad));
        EXPECT_THROW(world.destroy(bad), Misuse);
        EXPECT_THROW(world.add(bad, Health{}), Misuse);
        EXPECT_THROW(world.remove<Position>(bad), Misuse);
        EXPECT_THROW((void)world.has<Position>(bad), Misuse);
        EXPECT_THROW((void)world.get<Position>(bad), Misuse);
        EXPECT_THROW((void)world.get_mut<Position>(bad), Misuse);
        EXPECT_THROW((void)world.try_get<Position>(bad), Misuse);
        EXPECT_THROW((void)world.try_get_mut<Position>(bad), Misuse);
    }
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST(World, RemovingWhatIsNotThereIsMisuseAndChangesNothing) {
    World world;
    const Entity entity = world.create(Position{1, 2, 3});
    EXPECT_THROW(world.remove<Velocity>(entity), Misuse);
    EXPECT_EQ(world.get<Position>(entity), (Position{1, 2, 3}));
}

TEST(World, RefusesStructuralChangesWhileIterating) {
    World world;
    const Entity entity = world.create(Position{1, 2, 3});
    Query<const Position> query;
    for (const auto& chunk : query.chunks(world)) {
        (void)chunk;
        EXPECT_THROW(world.create(), Misuse);
        EXPECT_THROW(world.create(Position{}), Misuse);
        EXPECT_THROW(world.destroy(entity), Misuse);
        EXPECT_THROW(world.add(entity, Velocity{}), Misuse);
        EXPECT_THROW(world.add(entity, Position{}), Misuse);
        EXPECT_THROW(world.remove<Position>(entity), Misuse);
        World other;
        EXPECT_NO_THROW(other.create(Position{})) << "only the iterated world is closed";
    }
    EXPECT_THROW(query.each(world, [&](const Position&) { world.destroy(entity); }), Misuse);
    EXPECT_NO_THROW(world.destroy(entity)) << "open again, also after an exception ended the loop";
}

TEST(World, StatesItsLimitsAndKeepsWhatItHas) {
    for (bool reserves : {true, false}) {
        World world{
            {.max_entities = 5000, .max_rows_per_archetype = 2048, .reserve_address_space = reserves}};
        std::vector<Entity> entities;
        for (int i = 0; i < 2048; ++i)
            entities.push_back(world.create(Health{i}));
        EXPECT_THROW(world.create(Health{}), CapacityExceeded);
        const Entity other = world.create(Position{});
        world.add(other, Velocity{});
        world.remove<Position>(other);
        world.remove<Velocity>(other);
        EXPECT_THROW(world.add(other, Health{9}), CapacityExceeded) << "moving there needs a row too";
        EXPECT_FALSE(world.has<Health>(other));
        EXPECT_EQ(world.entity_count(), 2049u);
        for (int i = 0; i < 2048; ++i)
            ASSERT_EQ(world.get<Health>(entities[static_cast<std::size_t>(i)]).points, i);
        world.destroy(entities[3]);
        EXPECT_NO_THROW(world.add(other, Health{9}));
        EXPECT_EQ(world.get<Health>(other).points, 9);
    }
    World world{{.max_entities = 10}};
    for (int i = 0; i < 10; ++i)
        world.create();
    EXPECT_THROW(world.create(), CapacityExceeded);
    EXPECT_THROW(world.create(Health{}), CapacityExceeded);
    EXPECT_EQ(world.entity_count(), 10u);
}

TEST(World, KeepsOneResourceOfAType) {
    World world;
    EXPECT_FALSE(world.has_resource<Health>());
    Health& first = world.set_resource(Health{1});
    EXPECT_EQ(&world.set_resource(Health{2}), &first) << "references stay good";
    EXPECT_EQ(std::as_const(world).resource<Health>().points, 2);
    world.set_resource(Owner{std::make_unique<int>(3)});
    EXPECT_EQ(*world.resource<Owner>().value, 3);
}

TEST(World, EndsResourcesLastComeFirst) {
    static std::string order;
    struct Noted {
        explicit Noted(char c) : letter{c} {}
        Noted(Noted&& other) noexcept : letter{std::exchange(other.letter, '\0')} {}
        ~Noted() {
            if (letter != '\0') order += letter;
        }
        char letter;
    };
    struct A : Noted {
        A() : Noted{'a'} {}
    };
    struct B : Noted {
        B() : Noted{'b'} {}
    };
    {
        World world;
        world.set_resource(B{});
        world.set_resource(A{});
        world.set_resource(B{});
    }
    EXPECT_EQ(order, "bab") << "the replaced b, then in the reverse order of their coming";
}

TEST(World, CountsTheMemoryThatItCommits) {
    World world;
    const std::size_t empty = world.memory_bytes();
    EXPECT_LT(empty, 100'000u);
    for (int i = 0; i < 1'100'000; ++i)
        world.create(Position{}, Velocity{});
    const double per_entity = static_cast<double>(world.memory_bytes() - empty) / 1.1e6;
    // 24 bytes of components, 8 of the Entity column and 12 of the record are the least; growth by 1/32
    // and whole pages may add at most that.
    EXPECT_GE(per_entity, 44.0);
    EXPECT_LE(per_entity, 44.0 * 33.0 / 32.0 + 0.1);
    RecordProperty("bytes_per_entity", std::to_string(per_entity));
}

template <int... N>
void add_parts(World& world, Entity entity, unsigned mask, std::integer_sequence<int, N...>) {
    const auto one = [&]<int K>(std::integral_constant<int, K>) {
        if ((mask >> static_cast<unsigned>(K) & 1u) != 0)
            world.add(entity, Part<K>{static_cast<float>(mask)});
    };
    (one(std::integral_constant<int, N>{}), ...);
}

std::size_t mapped_areas() {
    std::ifstream maps{"/proc/self/maps"};
    std::size_t lines = 0;
    for (std::string line; std::getline(maps, line);)
        ++lines;
    return lines;
}

TEST(World, TenThousandSmallArchetypesShareMemory) {
    constexpr unsigned k_archetypes = 10'000;
    const std::size_t areas_before = mapped_areas();
    World world;
    std::vector<Entity> entities;
    for (unsigned mask = 0; mask < k_archetypes; ++mask) {
        for (int copy = 0; copy < 3; ++copy) {
            entities.push_back(world.create());
            add_parts(world, entities.back(), mask, std::make_integer_sequence<int, 14>{});
        }
    }
    EXPECT_EQ(world.archetype_count(), k_archetypes);
    // Linux allows 65 530 in all; reserved columns would take two each, some 130 000 here.
    EXPECT_LT(mapped_areas(), areas_before + k_archetypes / 10);
    // A mask has 6.6 of 14 parts on average: a block of 16 rows with 8 + 6.6·4 bytes, rounded up, is 0.7 KiB;
    // the tables of an archetype and its edges take the rest.
    EXPECT_LT(world.memory_bytes() / k_archetypes, 2048u);
    RecordProperty("bytes_per_archetype", static_cast<int>(world.memory_bytes() / k_archetypes));

    Query<const Part<0>, const Part<13>> query;
    std::size_t expected = 0;
    for (unsigned mask = 0; mask < k_archetypes; ++mask)
        expected += (mask & 1u) != 0 && (mask >> 13u & 1u) != 0 ? 3 : 0;
    EXPECT_EQ(query.count(world), expected);
    for (unsigned mask = 1; mask < k_archetypes; mask += 2) {
        ASSERT_EQ(world.get<Part<0>>(entities[mask * 3u]).value, static_cast<float>(mask));
    }
}

}  // namespace
}  // namespace rambla::ecs
