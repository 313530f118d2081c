#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "ecs/iteration.h"
#include "ecs/job.h"
#include "ecs/parameter.h"
#include "ecs/query.h"
#include "ecs/term_access.h"
#include "ecs/world_access.h"

namespace rambla::ecs {

/// System parameter: a query of the schedule's world, in the terms of Query. Declares what its terms read and
/// write. Changed terms mean: in the last run in which this system ran, or since; so no write is missed, and
/// those of that same run that came before may be seen twice. A system's jobs may walk and count its views
/// side by side (chunks, each, count) if the terms only read and the system itself makes no archetypes.
///     schedule.add("move", [](View<Position, const Velocity> moving) {
///         moving.for_each_chunk([](const auto& chunk) {
///             chunk.each([](Position& p, const Velocity& v) { p.x += v.x; });
///         });
///     });
template <class... Terms>
class View {
public:
    using ChunkType = typename Query<Terms...>::ChunkType;

    /// What the schedule keeps for it from run to run.
    struct State {
        Query<Terms...> query;
        std::vector<ChunkType> chunks;
        detail::LoopCost cost;
        Since since;              ///< for Changed terms
        std::uint32_t until = 0;  ///< the next run's `since`
        std::uint64_t world = 0;  ///< serial of the one looked at
    };
    View(State& state, detail::SystemContext& context) : state_{&state}, context_{&context} {}

    /// One chunk after the other, on this thread.
    [[nodiscard]] auto chunks() const {
        if constexpr (Query<Terms...>::k_asks_changes) {
            return state_->query.chunks(*context_->world, state_->since);
        } else {
            return state_->query.chunks(*context_->world);
        }
    }
    /// Calls f(…) for every row, on this thread; see Query::each.
    template <class F>
    void each(F&& f) const {
        for (const auto& chunk : chunks())
            chunk.each(f);
    }
    /// Number of matching entities; see Query::count.
    [[nodiscard]] std::size_t count() const {
        if constexpr (Query<Terms...>::k_asks_changes) {
            return state_->query.count(*context_->world, state_->since);
        } else {
            return state_->query.count(*context_->world);
        }
    }

    /// Calls f(chunk) or f(chunk, Job) for every chunk, side by side on the schedule's threads if that pays;
    /// returns when all are done. f may write the chunk's rows and record under its Job, nothing else that
    /// other calls may touch. All chunks get their turn even when some throw; then the exception of the first
    /// one, in the order of the chunks, is thrown.
    template <class F>
    void for_each_chunk(F&& f) const {
        State& state = *state_;
        state.chunks.clear();
        const auto range = chunks();
        std::size_t rows = 0;
        for (const ChunkType& chunk : range) {
            state.chunks.push_back(chunk);
            rows += chunk.size();
        }
        const std::uint32_t first_job = context_->open_jobs(static_cast<std::uint32_t>(state.chunks.size()));
        auto one = [&](std::size_t i, std::size_t run) {
            const ChunkType& chunk = state.chunks[i];
            if constexpr (std::is_invocable_v<F&, const ChunkType&, Job>) {
                f(chunk, Job{first_job + static_cast<std::uint32_t>(i),
                             first_job + static_cast<std::uint32_t>(run)});
            } else {
                f(chunk);
            }
        };
        detail::run_jobs(
            *context_, state.cost, state.chunks.size(), rows,
            [](void* job, std::size_t i, std::size_t run) { (*static_cast<decltype(one)*>(job))(i, run); },
            &one);
    }

private:
    State* state_;
    detail::SystemContext* context_;
};

/// System parameter: looks up components of single entities, for reading.
///     [](View<const Wheel, Rotation> wheels, Lookup<const Speed> of) { … of.template
///     try_get<Speed>(wheel.car) … }
template <class... Cs>
class Lookup {
    static_assert((std::is_const_v<Cs> && ...), "a Lookup only reads: Lookup<const C>");

public:
    explicit Lookup(const World& world) : world_{&world} {}

    /// See World::alive.
    [[nodiscard]] bool alive(Entity entity) const { return world_->alive(entity); }
    /// See World::get.
    template <class C>
    requires((std::is_same_v<const C, Cs> || ...)) [[nodiscard]] const C& get(Entity entity) const {
        return world_->get<C>(entity);
    }
    /// See World::try_get.
    template <class C>
    requires((std::is_same_v<const C, Cs> || ...)) [[nodiscard]] const C* try_get(Entity entity) const {
        return world_->try_get<C>(entity);
    }

private:
    const World* world_;
};

namespace detail {

template <class... Terms>
struct Parameter<View<Terms...>> : PlainParameter {
    static void declare(Declaration& declaration) {
        const auto add = [&](const AccessPart& part) {
            declaration.access.add(part);
        };
        (TermAccess<Terms>::visit(add), ...);
    }
    View<Terms...> fetch(SystemContext& context) {
        const World& world = *context.world;
        if (state.world != WorldAccess::serial(world)) {
            state.world = WorldAccess::serial(world);
            state.until = world.version() - k_before_all_versions;
        }
        state.since.version = std::exchange(state.until, world.version() - 1);
        state.query.find_archetypes(world);
        return {state, context};
    }

    typename View<Terms...>::State state;
};

/// A query that the system owns, for use with its World&.
template <class... Terms>
struct Parameter<Query<Terms...>> : PlainParameter {
    static void declare(Declaration& declaration) {
        declaration.limits_world = true;
        const auto add = [&](const AccessPart& part) {
            declaration.access.add(part);
        };
        (TermAccess<Terms>::visit(add), ...);
    }
    Query<Terms...>& fetch(SystemContext&) { return query; }

    Query<Terms...> query;
};

template <class... Cs>
struct Parameter<Lookup<Cs...>> : PlainParameter {
    static void declare(Declaration& declaration) {
        (declaration.access.add(access_part<std::remove_const_t<Cs>>(AccessKind::component, false)), ...);
    }
    static Lookup<Cs...> fetch(SystemContext& context) { return Lookup<Cs...>{*context.world}; }
};

}  // namespace detail
}  // namespace rambla::ecs
