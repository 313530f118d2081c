#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "ecs/command_arena.h"
#include "ecs/command_queue.h"
#include "ecs/commands.h"
#include "ecs/query.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

/// Recordings keep neighbouring commands of one type behind each other. Here is what ends such a run.
namespace rambla::ecs {
namespace {

using namespace test;

/// Tells, each time it is moved, whether it lies where its type may lie.
template <std::size_t Size, std::size_t Alignment>
struct alignas(Alignment) Stone {
    std::array<unsigned char, Size> bytes{};

    explicit Stone(unsigned number = 0) { bytes[0] = static_cast<unsigned char>(number); }
    Stone(Stone&& other) noexcept : bytes{other.bytes} {
        lies_right = lies_right && reinterpret_cast<std::uintptr_t>(this) % Alignment == 0;
    }
    ~Stone() = default;

    inline static bool lies_right = true;
};
using Grain = Stone<1, 1>;
using Pebble = Stone<3, 1>;
using Brick = Stone<6, 2>;
using Slab = Stone<24, 8>;
using Column = Stone<48, 16>;
using Pillar = Stone<65, 64>;

/// A block of the arena has room for one.
struct Boulder {
    std::array<std::uint32_t, 3 * CommandArena::k_block_bytes / 16> numbers{};
};
/// A block has room for none.
struct Mountain {
    std::array<std::uint32_t, CommandArena::k_block_bytes> numbers{};
};

std::vector<Entity> with_health(World& world, int count) {
    std::vector<Entity> entities;
    for (int i = 0; i < count; ++i)
        entities.push_back(world.create(Health{i}));
    return entities;
}

TEST(CommandRuns, AnotherTypeBetweenTakesNothingFromItsNeighbours) {
    World world;
    const std::vector<Entity> entities = with_health(world, 600);
    Commands commands;
    std::size_t recorded = 0;
    for (std::size_t i = 0; i < 600; ++i) {
        commands.add(entities[i], Position{static_cast<float>(i), 0, 0});
        ASSERT_EQ(commands.size(), ++recorded);
        if (i % 7 != 0) continue;
        commands.add(entities[i], Owner{std::make_unique<int>(static_cast<int>(i))});
        commands.remove<Health>(entities[i]);
        commands.create(Byte{static_cast<std::uint8_t>(i / 7)}, Velocity{1, 2, static_cast<float>(i)});
        ASSERT_EQ(commands.size(), recorded += 3);
    }
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, recorded);
    EXPECT_EQ(playback.dropped, 0u);
    EXPECT_EQ(commands.size(), 0u);
    for (std::size_t i = 0; i < 600; ++i) {
        ASSERT_EQ(world.get<Position>(entities[i]).x, static_cast<float>(i));
        ASSERT_EQ(world.has<Health>(entities[i]), i % 7 != 0);
        if (i % 7 == 0) {
            ASSERT_EQ(*world.get<Owner>(entities[i]).value, static_cast<int>(i));
        } else {
            ASSERT_EQ(world.get<Health>(entities[i]).points, static_cast<int>(i));
        }
    }
    Query<const Byte, const Velocity> made;
    std::uint8_t next = 0;
    made.each(world, [&](const Byte& byte, const Velocity& velocity) {
        ASSERT_EQ(byte.value, next++);
        ASSERT_EQ(velocity, (Velocity{1, 2, 7.0f * byte.value}));
    });
    EXPECT_EQ(next, 86);
}

TEST(CommandRuns, GoOnInTheNextBlockOfTheArena) {
    constexpr std::size_t k_count = 20'000;
    static_assert(k_count * sizeof(Position) > 3 * CommandArena::k_block_bytes);
    World world;
    const std::vector<Entity> entities = with_health(world, k_count);
    Commands commands;
    for (int round = 0; round < 2; ++round) {  // with blocks that are new, and with those that are kept
        for (std::size_t i = 0; i < k_count; ++i) {
            commands.add(entities[i], Position{static_cast<float>(i), 5, 6});
            ASSERT_EQ(commands.size(), i + 1);
        }
        EXPECT_EQ(commands.apply(world).applied, k_count);
        for (std::size_t i = 0; i < k_count; ++i)
            ASSERT_EQ(world.get<Position>(entities[i]), (Position{static_cast<float>(i), 5, 6}));
        for (Entity entity : entities)
            commands.remove<Position>(entity);
        EXPECT_EQ(commands.apply(world).applied, k_count);
    }
}

TEST(CommandRuns, OwningValuesGoOnInTheNextBlockAndEndWhereNobodyTakesThem) {
    constexpr int k_count = 5000;
    static_assert(k_count * sizeof(Anchored) > CommandArena::k_block_bytes);
    const int before = Anchored::alive;
    {
        World world{{.max_rows_per_archetype = k_count + 50}};
        const std::vector<Entity> entities = with_health(world, k_count);
        const Entity other = world.create();
        Commands commands;
        const auto record = [&] {
            for (int i = 0; i < k_count; ++i)
                commands.add(entities[static_cast<std::size_t>(i)], Anchored{i});
        };
        record();
        commands.clear();
        EXPECT_EQ(Anchored::alive, before);
        record();
        EXPECT_EQ(commands.apply(world).applied, static_cast<std::size_t>(k_count));
        record();  // values that take the place of others
        commands.add(other, Anchored{k_count});
        EXPECT_EQ(commands.apply(world).applied, static_cast<std::size_t>(k_count) + 1);
        EXPECT_EQ(Anchored::alive, before + k_count + 1);
        for (int i = 0; i < k_count; ++i) {
            ASSERT_TRUE(world.get<Anchored>(entities[static_cast<std::size_t>(i)]).intact());
            ASSERT_EQ(world.get<Anchored>(entities[static_cast<std::size_t>(i)]).number(), i);
        }
        for (int i = 0; i < k_count; ++i)
            commands.add(world.create(Byte{}), Anchored{i});
        for (int i = 0; i < 100; ++i)
            world.create(Byte{}, Anchored{i});
        EXPECT_THROW(commands.apply(world), CapacityExceeded);
        EXPECT_EQ(Anchored::alive, before + k_count + 101);
    }
    EXPECT_EQ(Anchored::alive, before);
}

template <class Huge>
void give_and_expect_huge() {
    World world;
    const std::vector<Entity> entities = with_health(world, 40);
    Commands commands;
    const auto huge = std::make_unique<Huge>();
    for (std::uint32_t i = 0; i < 40; ++i) {
        huge->numbers.front() = i;
        huge->numbers.back() = i;
        commands.add(entities[i], *huge);
    }
    EXPECT_EQ(commands.apply(world).applied, 40u);
    for (std::uint32_t i = 0; i < 40; ++i) {
        EXPECT_EQ(world.get<Huge>(entities[i]).numbers.front(), i);
        EXPECT_EQ(world.get<Huge>(entities[i]).numbers.back(), i);
    }
}

TEST(CommandRuns, ValuesAsLargeAsABlockAreRunsOfTheirOwn) {
    give_and_expect_huge<Boulder>();
    give_and_expect_huge<Mountain>();
}

/// Gives each of 40 entities, more than a playback without a plan needs, a stone with its number.
template <class S>
void give_stones(Commands& commands, const std::vector<Entity>& entities) {
    for (std::size_t i = 0; i < entities.size(); ++i)
        commands.add(entities[i], S{static_cast<unsigned>(i)});
}
template <class S>
void expect_stones(World& world, const std::vector<Entity>& entities) {
    for (std::size_t i = 0; i < entities.size(); ++i)
        ASSERT_EQ(world.get<S>(entities[i]).bytes[0], i);
    EXPECT_TRUE(S::lies_right) << sizeof(S);
}

TEST(CommandRuns, EveryValueLiesAsItsTypeDemands) {
    const auto check = [](bool in_turns) {
        World world;
        const std::vector<Entity> entities = with_health(world, 40);
        Commands commands;
        if (in_turns) {
            for (std::size_t i = 0; i < entities.size(); ++i) {
                const auto number = static_cast<unsigned>(i);
                commands.add(entities[i], Grain{number});
                commands.add(entities[i], Pillar{number});
                commands.add(entities[i], Pebble{number});
                commands.add(entities[i], Slab{number});
                commands.add(entities[i], Brick{number});
                commands.add(entities[i], Column{number});
            }
            commands.apply(world);
        } else {
            give_stones<Grain>(commands, entities);
            give_stones<Pillar>(commands, entities);
            give_stones<Pebble>(commands, entities);
            commands.apply(world);
            give_stones<Slab>(commands, entities);
            commands.apply(world);
            give_stones<Brick>(commands, entities);
            commands.apply(world);
            give_stones<Column>(commands, entities);
            commands.apply(world);
        }
        expect_stones<Grain>(world, entities);
        expect_stones<Pillar>(world, entities);
        expect_stones<Pebble>(world, entities);
        expect_stones<Slab>(world, entities);
        expect_stones<Brick>(world, entities);
        expect_stones<Column>(world, entities);
    };
    check(true);
    check(false);
    World world;
    Commands commands;
    for (unsigned i = 0; i < 40; ++i)
        commands.create(Grain{i}, Pillar{i}, Pebble{i}, Slab{i});
    commands.apply(world);
    Query<const Grain, const Pillar, const Pebble, const Slab> made;
    unsigned next = 0;
    made.each(world, [&](const Grain& grain, const Pillar& pillar, const Pebble& pebble, const Slab& slab) {
        ASSERT_EQ(grain.bytes[0], next);
        ASSERT_EQ(pillar.bytes[0], next);
        ASSERT_EQ(pebble.bytes[0], next);
        ASSERT_EQ(slab.bytes[0], next++);
    });
    EXPECT_EQ(next, 40u);
    EXPECT_TRUE(Grain::lies_right && Pillar::lies_right && Pebble::lies_right && Slab::lies_right);
}

TEST(CommandRuns, SeveralRecordingsOfOneTypeArriveAsOne) {
    World world;
    const std::vector<Entity> entities = with_health(world, 2000);
    CommandQueue queue;
    std::vector<Entity> order;
    // Recordings from none to 70 commands: shorter and longer than what is fetched ahead.
    for (std::uint32_t job = 0; order.size() < 2000; ++job) {
        Commands& commands = queue.recording({0, job});
        for (std::size_t i = 0; i < job * 13 % 71 && order.size() < 2000; ++i) {
            const Entity entity = entities[order.size() * 1009 % 2000];
            commands.add(entity, Position{static_cast<float>(order.size()), 0, 0});
            order.push_back(entity);
        }
    }
    EXPECT_EQ(queue.apply(world).applied, 2000u);
    std::size_t next = 0;
    Query<Entity, const Position> placed;
    placed.each(world, [&](Entity entity, const Position& position) {
        ASSERT_EQ(entity, order[next]);
        ASSERT_EQ(position.x, static_cast<float>(next++));
    });
    EXPECT_EQ(next, 2000u);
}

TEST(CommandRuns, PlaceholdersStayThoseOfTheirRecording) {
    World world;
    const Entity old = world.create(Health{-1});
    CommandQueue queue;
    for (std::uint32_t job = 0; job < 5; ++job) {
        Commands& commands = queue.recording({0, job});
        for (int i = 0; i < 4; ++i) {
            const Entity made = commands.create(Health{i});
            commands.add(made, Byte{static_cast<std::uint8_t>(job)});
            commands.add(made, Parent{made});
            if (i == 2) commands.add(Entity{99, 0}, Health{99});  // of no recording
        }
        commands.add(old, Health{static_cast<int>(job)});
    }
    const Playback playback = queue.apply(world);
    EXPECT_EQ(playback.applied, 5u * 13);
    EXPECT_EQ(playback.dropped, 5u);
    int next = 0;
    Query<Entity, const Health, const Byte, const Parent> made;
    made.each(world, [&](Entity entity, const Health& health, const Byte& byte, const Parent& parent) {
        ASSERT_EQ(health.points, next % 4);
        ASSERT_EQ(byte.value, next / 4);
        ASSERT_EQ(parent.entity, entity);
        ++next;
    });
    EXPECT_EQ(next, 20);
    EXPECT_EQ(world.get<Health>(old).points, 4);
}

TEST(CommandRuns, CommandsForAllDivideThemWhereTheyStand) {
    World world;
    const std::vector<Entity> entities = with_health(world, 100);
    Commands commands;
    for (Entity entity : entities)
        commands.add(entity, Position{1, 1, 1});
    commands.add_to_all<Position, With<Health>>({2, 2, 2});
    commands.add_to_all<Position, With<Health>>({3, 3, 3});
    for (std::size_t i = 0; i < 50; ++i)
        commands.add(entities[i], Position{4, 4, 4});
    EXPECT_EQ(commands.size(), 152u);
    EXPECT_EQ(commands.apply(world).applied, 152u);
    for (std::size_t i = 0; i < 100; ++i)
        ASSERT_EQ(world.get<Position>(entities[i]).x, i < 50 ? 4.0f : 3.0f);
}

TEST(CommandRuns, ValuesOfAPlaybackThatStopsInTheMiddleEndOnceEach) {
    const int before = Anchored::alive;
    {
        World world{{.max_entities = 200}};
        const std::vector<Entity> entities = with_health(world, 100);
        Commands commands;
        CommandQueue queue;
        for (std::uint32_t job = 0; job < 3; ++job) {
            Commands& recording = queue.recording({0, job});
            for (Entity entity : entities)
                recording.add(entity, Anchored{static_cast<int>(job)});
            if (job != 1) continue;
            recording.add_to_all<Frozen, With<Health>>();
            for (int i = 0; i < 101; ++i)  // one more than fits
                recording.create(Anchored{i}, Byte{});
            recording.remove<Health>(entities[0]);
        }
        EXPECT_THROW(queue.apply(world), CapacityExceeded);
        EXPECT_TRUE(queue.empty());
        EXPECT_EQ(Anchored::alive, before + 100);
        for (Entity entity : entities) {
            ASSERT_EQ(world.get<Anchored>(entity).number(), 1) << "what came before the part that failed";
            ASSERT_TRUE(world.has<Frozen>(entity));
        }
    }
    EXPECT_EQ(Anchored::alive, before);
}

TEST(CommandRuns, ACommandThatFindsNoMemoryLeavesTheRecordingAsItWas) {
    const int before = Anchored::alive;
    std::size_t failures = 0;
    for (std::size_t number = 0;; ++number) {
        World world;
        const std::vector<Entity> entities = with_health(world, 300);
        Commands commands;
        bool happened = false;
        {
            const rambla::test::FailingAllocation failing{number};
            for (std::size_t i = 0; i < 300; ++i) {
                const auto record = [&](auto command) {
                    const std::size_t recorded = commands.size();
                    try {
                        command();
                    } catch (const std::bad_alloc&) {
                        ++failures;
                        ASSERT_EQ(commands.size(), recorded);
                        command();
                    }
                    ASSERT_EQ(commands.size(), recorded + 1);
                };
                // More values of one type than the first block of the arena has room for, then others.
                if (i / 150 % 2 == 0) {
                    record([&] { commands.add(entities[i], Anchored{static_cast<int>(i)}); });
                } else {
                    record([&] { commands.add(entities[i], Line{}); });
                    record([&] { commands.remove<Health>(entities[i]); });
                }
            }
            happened = failing.happened();
        }
        EXPECT_EQ(commands.apply(world).applied, 450u);
        for (std::size_t i = 0; i < 300; ++i) {
            ASSERT_EQ(world.has<Line>(entities[i]), i / 150 % 2 == 1);
            ASSERT_EQ(world.has<Health>(entities[i]), i / 150 % 2 == 0);
            if (i / 150 % 2 == 1) continue;
            ASSERT_TRUE(world.get<Anchored>(entities[i]).intact());
            ASSERT_EQ(world.get<Anchored>(entities[i]).number(), static_cast<int>(i));
        }
        if (!happened) break;
    }
    EXPECT_GT(failures, 10u);
    EXPECT_EQ(Anchored::alive, before);
}

TEST(CommandRuns, MemoryIsThatOfEntitiesAndValues) {
    World world;
    const std::vector<Entity> entities = with_health(world, 100'000);
    Commands commands;
    for (Entity entity : entities)
        commands.add(entity, Position{});
    const std::size_t bytes = commands.memory_bytes();
    EXPECT_GE(bytes, 100'000 * (sizeof(Entity) + sizeof(Position)));
    // A table of entities has at most twice the room that it needs; blocks leave over what no value fits in.
    EXPECT_LE(bytes, 100'000 * (2 * sizeof(Entity) + sizeof(Position)) + 2 * CommandArena::k_block_bytes);
}

}  // namespace
}  // namespace rambla::ecs
