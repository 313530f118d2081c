#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ecs/commands.h"
#include "ecs/schedule.h"
#include "ecs/world.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::property {

/// Resources whose values depend on the order in which systems touch them.
struct Tally {
    std::uint64_t value = 0;
};
struct Heard {
    std::uint64_t value = 0;
};
/// An event.
struct Shout {
    std::uint32_t number = 0;
};

/// What one system keeps from run to run when it is performed the naive way.
struct NaiveState {
    std::uint32_t until = 0;  ///< version up to which it has seen changes
    std::size_t unread = 0;   ///< number of the next event
};

/// A world in which systems are performed one after the other, row by row, with one recording for all.
struct NaiveRun {
    World& world;
    Commands commands;
    std::vector<Shout> shouts;  ///< all that were ever written
};

/// A kind of system: what is done to rows is written once, how rows and commands are come by is not.
/// `k` tells systems of one kind apart: numbers, and how much work a row is.
struct SystemKind {
    std::string_view name;
    Schedule::Added (*add)(Schedule& schedule, std::string name, std::uint32_t k);
    void (*perform)(NaiveRun& run, NaiveState& state, std::uint32_t k);
};

[[nodiscard]] std::span<const SystemKind> system_kinds();

}  // namespace rambla::ecs::property
