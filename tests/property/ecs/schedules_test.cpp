#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "ecs/snapshot.h"
#include "property/ecs/random_systems.h"
#include "property/ecs/reflected_parts.h"

namespace rambla::ecs::property {
namespace {

constexpr std::size_t k_runs = 5;

/// One system of a random schedule.
struct ChosenSystem {
    const SystemKind* kind = nullptr;
    std::string name;
    std::uint32_t k = 0;
    std::size_t stage = 0;
    std::vector<std::size_t> after;  ///< systems of its stage, by number, that come later in the declaration
    bool says_before = false;        ///< those say so instead
};

using ChosenSystems = std::vector<ChosenSystem>;

ChosenSystems choose_systems(std::mt19937& random) {
    ChosenSystems systems(4 + random() % 16);
    std::size_t stage = 0;
    for (std::size_t i = 0; i < systems.size(); ++i) {
        ChosenSystem& system = systems[i];
        system.kind = &system_kinds()[random() % system_kinds().size()];
        system.k = static_cast<std::uint32_t>(random());
        system.name = std::string{system.kind->name} + " " + std::to_string(i);
        stage += i != 0 && random() % 5 == 0 ? 1 : 0;
        system.stage = stage;
    }
    for (std::size_t i = 0; i < systems.size(); ++i) {
        systems[i].says_before = random() % 2 == 0;
        for (std::size_t j = i + 1; j < systems.size() && systems[j].stage == systems[i].stage; ++j) {
            if (random() % 12 == 0) systems[i].after.push_back(j);
        }
    }
    return systems;
}

void declare(Schedule& schedule, const ChosenSystems& systems) {
    for (std::size_t i = 0; i < systems.size(); ++i) {
        const ChosenSystem& system = systems[i];
        if (i != 0 && system.stage != systems[i - 1].stage) schedule.sync();
        Schedule::Added added = system.kind->add(schedule, system.name, system.k);
        for (std::size_t j = 0; j < i; ++j) {
            if (systems[j].says_before && std::ranges::count(systems[j].after, i) != 0)
                added.before(systems[j].name);
        }
        if (system.says_before) continue;
        for (const std::size_t j : system.after)
            added.after(systems[j].name);
    }
}

/// As declared, but what must come before a system right before it.
void put_in_order(const ChosenSystems& systems, std::size_t i, std::vector<std::size_t>& order) {
    if (std::ranges::find(order, i) != order.end()) return;
    std::vector<std::size_t> first = systems[i].after;
    std::ranges::sort(first);
    for (const std::size_t j : first)
        put_in_order(systems, j, order);
    order.push_back(i);
}

/// Entities of a few kinds, in archetypes of many chunks and of few rows.
void populate(World& world, std::uint32_t seed) {
    world.set_resource(Tally{seed});
    world.set_resource(Heard{});
    std::mt19937 random{seed};
    for (int i = 0; i < 8000; ++i) {
        const auto n = static_cast<int>(random() >> 1u);
        const auto x = static_cast<float>(random() % 1000);
        switch (random() % 8) {
            case 0:
                world.create(Health{n}, Byte{}, Light{x});
                break;
            case 1:
                world.create(Score{n}, Burning{n}, Frozen{});
                break;
            case 2:
                world.create(Health{n}, Material{static_cast<std::uint32_t>(n) % 3}, Score{n});
                break;
            case 3:
                world.create(Position{x, 0, 0}, Light{x}, Score{n});
                break;
            default:
                world.create(Health{n}, Position{x, 0, 0}, Score{n});
        }
    }
}

/// The bytes of a world, and what its resources have come to.
struct State {
    std::vector<std::byte> bytes;
    std::uint64_t tally = 0;
    std::uint64_t heard = 0;
    bool operator==(const State&) const = default;
};

class Recorder {
public:
    State state_of(World& world) {
        const std::span<const std::byte> bytes = writer_.write(world);
        return {{bytes.begin(), bytes.end()},
                std::as_const(world).resource<Tally>().value,
                std::as_const(world).resource<Heard>().value};
    }

private:
    TypeRegistry registry_ = parts_registry();
    SnapshotWriter writer_{registry_};
};

std::vector<State> naive_states(const ChosenSystems& systems, std::uint32_t seed) {
    World world;
    populate(world, seed);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < systems.size(); ++i)
        put_in_order(systems, i, order);
    std::vector<NaiveState> kept(systems.size());
    NaiveRun run{world, {}, {}};
    Recorder recorder;
    std::vector<State> states;
    for (std::size_t i = 0; i < k_runs; ++i) {
        world.advance_version();
        for (std::size_t place = 0; place < order.size(); ++place) {
            const ChosenSystem& system = systems[order[place]];
            system.kind->perform(run, kept[order[place]], system.k);
            const bool last_of_stage =
                place + 1 == order.size() || systems[order[place + 1]].stage != system.stage;
            if (last_of_stage) run.commands.apply(world);
        }
        states.push_back(recorder.state_of(world));
    }
    return states;
}

std::string names_of(const ChosenSystems& systems) {
    std::string text;
    for (const ChosenSystem& system : systems) {
        text += "\n  stage " + std::to_string(system.stage) + ": " + system.name + ", k " +
                std::to_string(system.k);
        for (const std::size_t j : system.after)
            text += ", after " + systems[j].name;
    }
    return text;
}

/// Number of the first run whose state is another one; k_runs if there is none.
std::size_t first_difference(const ChosenSystems& systems, std::uint32_t seed, std::size_t threads,
                             const std::vector<State>& expected) {
    World world;
    populate(world, seed);
    Schedule schedule{{.threads = threads}};
    declare(schedule, systems);
    Recorder recorder;
    for (std::size_t i = 0; i < k_runs; ++i) {
        schedule.run(world);
        if (recorder.state_of(world) != expected[i]) return i;
    }
    return k_runs;
}

/// Leaves out systems without which the difference stays.
ChosenSystems shortened(ChosenSystems systems, std::uint32_t seed, std::size_t threads) {
    for (std::size_t i = systems.size(); i-- > 0;) {
        ChosenSystems fewer = systems;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        for (ChosenSystem& system : fewer) {
            std::erase(system.after, i);
            for (std::size_t& j : system.after)
                j -= j > i ? 1 : 0;
        }
        if (fewer.empty()) continue;
        if (first_difference(fewer, seed, threads, naive_states(fewer, seed)) != k_runs)
            systems = std::move(fewer);
    }
    return systems;
}

/// The seed is the test's name.
class RandomSchedules : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomSchedules, LeaveTheSameBytesAsSystemsOneByOne) {
    constexpr std::uint32_t k_schedules = 8;
    for (std::uint32_t i = 0; i < k_schedules; ++i) {
        const std::uint32_t seed = GetParam() * k_schedules + i;
        std::mt19937 random{seed};
        const ChosenSystems systems = choose_systems(random);
        const std::vector<State> expected = naive_states(systems, seed);
        for (const std::size_t threads : {1u, 2u, 8u}) {
            const std::size_t different = first_difference(systems, seed, threads, expected);
            ASSERT_EQ(different, k_runs)
                << "the run that differs first, with " << threads << " threads and seed " << seed
                << ", as with these systems:" << names_of(shortened(systems, seed, threads));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed, RandomSchedules, testing::Range<std::uint32_t>(1, 9));

}  // namespace
}  // namespace rambla::ecs::property
