#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ecs/access.h"

namespace rambla::ecs {

/// That a system begins only after another has ended, and why.
struct PlannedWait {
    std::size_t system = 0;  ///< index into Plan::systems
    bool declared = false;   ///< by before() or after()
    Conflict conflict;       ///< what both touch; `writes`: whether the earlier one writes it
};

/// A system in its place.
struct PlannedSystem {
    std::string name;
    std::size_t stage = 0;  ///< from 0
    AccessSet access;       ///< what it declares to touch
    /// Systems of the same stage, without those that other waits imply.
    std::vector<PlannedWait> waits;
};

/// Two conflicting systems whose order nothing but their place in the program decides.
struct Ambiguity {
    std::size_t first = 0;   ///< index into Plan::systems; runs first
    std::size_t second = 0;  ///< likewise; runs second
    Conflict conflict;       ///< what both touch; `writes`: whether the first writes it
};

/// What a schedule does: systems in the order in which they run on a single thread. With more threads a
/// system runs once its stage has begun and what it waits for has ended; a stage begins once the one before
/// it has ended and its recorded structural changes are made.
struct Plan {
    std::vector<PlannedSystem> systems;
    std::size_t stage_count = 0;
    std::vector<Ambiguity> ambiguities;  ///< those of the earliest systems first
};

/// For people: a line per system, what it waits for below it, ambiguities last.
[[nodiscard]] std::string to_text(const Plan& plan);

/// A type's name without namespaces: "Events<Hit>" of "ecs::Events<game::Hit>".
[[nodiscard]] std::string short_name(std::string_view type_name);

namespace detail {

/// What is known of a system before it has a place.
struct DeclaredSystem {
    std::string name;
    std::size_t stage = 0;
    AccessSet access;
    std::vector<std::string> before;
    std::vector<std::string> after;
};

/// A plan, and from where in the declarations its systems come.
struct MadePlan {
    Plan plan;
    std::vector<std::size_t> declared;  ///< by place in the plan
};

/// Throws Misuse, naming the systems, when before() and after() name what is not there or contradict each
/// other or the stages.
[[nodiscard]] MadePlan make_plan(const std::vector<DeclaredSystem>& systems);

}  // namespace detail
}  // namespace rambla::ecs
