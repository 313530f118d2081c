#include "ecs/misuse.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <functional>
#include <memory_resource>
#include <string>
#include <vector>

#include "ecs/archetype_graph.h"
#include "ecs/command_queue.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "unit/ecs/parts.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define RAMBLA_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define RAMBLA_SANITIZED 1
#endif
#endif

/// One test per line of the table "What misuse does" in ecs/README.md that no other file tests.
namespace rambla::ecs {
namespace {

using namespace test;

std::string complaint(const std::function<void()>& call) {
    try {
        call();
    } catch (const Misuse& misuse) {
        return misuse.what();
    }
    return "none";
}

/// Everything that takes a handle.
std::vector<std::function<void()>> calls_with(World& world, Entity entity) {
    return {[&world, entity] { world.destroy(entity); },
            [&world, entity] { world.add(entity, Position{}); },
            [&world, entity] { world.add(entity, Burning{1}); },
            [&world, entity] { world.add(entity, Selected{}); },
            [&world, entity] { world.remove<Position>(entity); },
            [&world, entity] { world.remove<Burning>(entity); },
            [&world, entity] { (void)world.has<Position>(entity); },
            [&world, entity] { (void)world.has<Burning>(entity); },
            [&world, entity] { (void)world.get<Position>(entity); },
            [&world, entity] { (void)world.get<Burning>(entity); },
            [&world, entity] { (void)world.get_mut<Position>(entity); },
            [&world, entity] { (void)world.try_get<Position>(entity); },
            [&world, entity] { (void)world.try_get_mut<Burning>(entity); },
            [&world, entity] { world.set_enabled<Light>(entity, false); },
            [&world, entity] { (void)world.enabled<Light>(entity); },
            [&world, entity] {
                world.get_many<Position>(std::span{&entity, 1}, [](std::size_t, const Position&) {});
            }};
}

TEST(Misuse, HandlesThatAreStaleNullOrPlaceholdersAreRefusedByEveryCall) {
    World world;
    const Entity stale = world.create(Position{}, Light{}, Burning{1});
    world.destroy(stale);
    const Entity heir = world.create(Position{7, 7, 7}, Light{}, Burning{7});
    ASSERT_EQ(heir.index, stale.index);
    Commands commands;
    const Entity handles[]{stale, Entity{}, commands.create(Health{1}), Entity{0x7fffffffu, 1}};
    for (const Entity handle : handles) {
        EXPECT_FALSE(world.alive(handle));
        for (const auto& call : calls_with(world, handle))
            EXPECT_NE(complaint(call).find("entity " + to_string(handle) + " is not alive"),
                      std::string::npos)
                << complaint(call);
    }
    EXPECT_EQ(world.entity_count(), 1u);
    EXPECT_EQ(world.get<Position>(heir).x, 7.0f);
    EXPECT_EQ(world.get<Burning>(heir).heat, 7);
}

TEST(Misuse, AHandleOfAnotherWorldIsNotTold) {
    // Worlds count their slots alike, so a handle may by chance be one of another world's.
    World one;
    World two;
    const Entity in_one = one.create(Health{1});
    EXPECT_FALSE(two.alive(in_one));
    const Entity in_two = two.create(Health{2});
    EXPECT_EQ(in_one, in_two);
}

TEST(Misuse, OtherWorldsMayBeChangedWhileOneIsWalkedOver) {
    World outer;
    World inner;
    outer.create(Health{1});
    outer.create(Health{2});
    Query<const Health> in_outer;
    Query<const Health> in_inner;
    std::size_t seen = 0;
    in_outer.each(outer, [&](const Health& health) {
        inner.create(Health{health.points});
        in_inner.each(inner, [&](const Health&) { ++seen; });
        EXPECT_THROW(outer.create(), Misuse);
    });
    EXPECT_EQ(seen, 3u);
    EXPECT_EQ(inner.entity_count(), 2u);
    outer.create();
}

TEST(Misuse, WalksMayBeNestedAndTheInnermostEndFreesNothing) {
    World world;
    const Entity entity = world.create(Health{1});
    Query<const Health> a;
    Query<Entity> b;
    for (const auto& outer : a.chunks(world)) {
        for (const auto& inner : b.chunks(world))
            EXPECT_EQ(inner.size(), outer.size());
        EXPECT_THROW(world.destroy(entity), Misuse);
    }
    world.destroy(entity);
}

TEST(Misuse, AWalkLeftByAnExceptionFreesTheWorld) {
    World world;
    world.create(Health{1});
    Query<const Health> query;
    EXPECT_THROW(query.each(world, [](const Health&) { throw 5; }), int);
    world.create(Health{2});
    EXPECT_EQ(world.entity_count(), 2u);
}

TEST(Misuse, SparseAndSwitchedPartsFollowTheSameRules) {
    World world;
    const Entity entity = world.create(Light{}, Burning{1});
    Query<const Light> query;
    for ([[maybe_unused]] const auto& chunk : query.chunks(world)) {
        EXPECT_THROW(world.add(entity, Selected{}), Misuse) << "sparse parts are structure too";
        EXPECT_THROW(world.remove<Burning>(entity), Misuse);
        world.set_enabled<Light>(entity, false);  // moves nothing
    }
    EXPECT_FALSE(world.enabled<Light>(entity));
    EXPECT_TRUE(world.has<Burning>(entity));
}

TEST(Misuse, MoreKindsOfComponentsThanHaveNumbersAreRefused) {
    ArchetypeGraph graph{1024, true, 1, std::pmr::new_delete_resource()};
    constexpr std::uint32_t k_kinds = 65533;
    std::vector<ComponentInfo> infos(k_kinds + 1);
    for (std::uint32_t i = 0; i <= k_kinds; ++i)
        infos[i].type_index = i;
    for (std::uint32_t i = 0; i < k_kinds; ++i)
        ASSERT_EQ(graph.component(infos[i]), i);
    EXPECT_THROW(graph.component(infos[k_kinds]), CapacityExceeded);
    EXPECT_EQ(graph.component(infos[5]), 5u);
}

#ifndef RAMBLA_SANITIZED  // their shadow memory needs more address space than any limit leaves

/// Bytes of address space that this process has.
rlim_t address_space() {
    rlim_t pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        unsigned long long read = 0;
        if (std::fscanf(file, "%llu", &read) == 1) pages = read;
        std::fclose(file);
    }
    return pages * 4096;
}

/// Ends the process with 0 if a world that the system gives little keeps what it has and goes on.
[[noreturn]] void fill_a_world_that_the_system_limits() {
    World world{{.max_entities = 1u << 20u, .max_rows_per_archetype = 1u << 20u}};
    const Entity first = world.create(Line{}, Health{1});
    const rlim_t limit = address_space() + (40u << 20u);
    const rlimit limits{limit, limit};
    if (setrlimit(RLIMIT_AS, &limits) != 0) std::_Exit(2);
    std::size_t created = 1;
    try {  // a column of Lines reserves 64 MiB once the rows leave the pool
        for (;; ++created)
            world.create(Line{}, Health{2});
    } catch (const CapacityExceeded&) {
    }
    if (world.entity_count() != created || created < 256) std::_Exit(3);
    if (world.get<Health>(first).points != 1) std::_Exit(4);
    Query<const Health> query;
    if (query.count(world) != created) std::_Exit(5);
    world.destroy(first);
    world.create(Line{}, Health{3});
    world.create(Health{4});
    std::_Exit(query.count(world) == created + 1 ? 0 : 6);
}

/// Ends the process with 0 if a world that asks for too much is refused, and a smaller one is not.
[[noreturn]] void make_a_world_that_the_system_refuses() {
    const rlim_t limit = address_space() + (40u << 20u);
    const rlimit limits{limit, limit};
    if (setrlimit(RLIMIT_AS, &limits) != 0) std::_Exit(2);
    try {
        World world;  // records for 2²⁸ entities
        std::_Exit(3);
    } catch (const CapacityExceeded&) {
    }
    World small{{.max_entities = 1000, .reserve_address_space = false}};
    small.create(Health{1});
    std::_Exit(small.entity_count() == 1 ? 0 : 4);
}

TEST(MisuseDeathTest, AWorldThatTheSystemRefusesAddressSpaceKeepsWhatItHas) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(fill_a_world_that_the_system_limits(), testing::ExitedWithCode(0), "");
}

TEST(MisuseDeathTest, AWorldTooLargeForTheAddressSpaceIsRefused) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(make_a_world_that_the_system_refuses(), testing::ExitedWithCode(0), "");
}

#endif

}  // namespace
}  // namespace rambla::ecs
