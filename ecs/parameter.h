#pragma once

#include "ecs/access.h"
#include "ecs/job.h"
#include "ecs/world.h"

namespace rambla::ecs::detail {

/// What the parameters of a system say about it.
struct Declaration {
    AccessSet access;
    bool takes_world = false;
    /// It declares what it does with its World&; otherwise it has the world for itself.
    bool limits_world = false;
    std::vector<JobLanes*> lanes;
    std::vector<void (*)(World&)> at_start_of_run;  ///< e.g. ageing of the events that it writes
};

/// How a schedule provides a parameter of type P (without const and reference). Specialisations hold what the
/// parameter keeps from run to run, and have:
///     void declare(Declaration&)                       once, at a place that it then stays at
///     void prepare(World&)                             before each run, while nothing else happens
///     … fetch(SystemContext&)                          what the system is called with
///     void finish(SystemContext&)                      after it returned, as its access allows
///     void forget() noexcept                           instead, after it threw
template <class P>
struct Parameter;

/// What most parameters have nothing to do for.
struct PlainParameter {
    void prepare(World&) {}
    void finish(SystemContext&) {}
    void forget() noexcept {}
};

/// The world, whole or as far as the system declares.
template <>
struct Parameter<World> : PlainParameter {
    static void declare(Declaration& declaration) { declaration.takes_world = true; }
    static World& fetch(SystemContext& context) { return *context.world; }
};

}  // namespace rambla::ecs::detail
