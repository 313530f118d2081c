#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "ecs/events.h"
#include "ecs/job_commands.h"
#include "ecs/parallel.h"
#include "ecs/plan.h"
#include "ecs/res.h"
#include "ecs/stage.h"
#include "ecs/system.h"
#include "ecs/view.h"

namespace rambla::ecs {

/// How a schedule runs its systems.
struct ScheduleOptions {
    /// 0: as many as oneTBB allows at each run; 1: one system after the other, on the calling thread. The
    /// world is the same after any number.
    std::size_t threads = 0;
};

/// When a system ran and how long it took, its parallel loops included.
struct SystemTime {
    std::string_view name;  ///< of the system
    std::uint64_t ns = 0;
    std::chrono::steady_clock::time_point begin{};
    std::thread::id thread{};  ///< that ran it; others may have taken part in its loops
};

/// Systems, run in an order that follows from what they declare to touch.
///
/// A system is a function, lambda or object whose parameters say what it needs:
///     View<Terms…>                       a query, see there; reads const C, writes C
///     Lookup<const C…>                   components of single entities, for reading
///     Res<R>, ResMut<R>                  a resource of the world
///     EventReader<E>, EventWriter<E>&    events
///     Commands&, JobCommands&            structural changes, made at the end of the stage
///     World&                             the world for itself, structural changes included
///     World&, Query<Terms…>&             the world as far as the queries, or reads() and writes(), declare
///
/// Systems that conflict (one writes what the other touches) run in the order of their declaration, unless
/// before() or after() say otherwise; others may run at the same time. sync() begins a new stage: all systems
/// before it have ended and their recorded changes are made, by the order of the plan and for each system its
/// own before those of its jobs, when those after it begin. The result depends on no timing and no
/// number of threads.
///
/// When a system throws, the other systems of its stage still run, then run() throws what the first one in
/// the order of the plan threw: Misuse stays Misuse, all else becomes SystemFailed, both name the system.
/// Structural changes recorded in the stage are dropped, and so are events of the systems that threw; later
/// stages do not run. The schedule can be run again.
///
/// A run advances the world's version once. A run that repeats the last one's amount of work does not
/// allocate.
class Schedule {
public:
    explicit Schedule(ScheduleOptions options = {});
    ~Schedule();
    Schedule(const Schedule&) = delete;
    Schedule& operator=(const Schedule&) = delete;

    /// Says more about a system than its parameters do. Valid until the next add().
    class Added {
    public:
        /// It ends before the system of that name begins. Throws Misuse, at the next plan() or run(), when
        /// there is none or the order contradicts itself.
        Added& before(std::string name);
        /// The other way round.
        Added& after(std::string name);
        /// Components that it reads or writes through its World&, which then is not for itself. Enable bits
        /// belong to their component: what writes C may call set_enabled<C>(), and runs apart from systems
        /// that ask Enabled<C>. EnableState<C> names the bits alone.
        template <class... Cs>
        Added& reads() {
            return touches<Cs...>(AccessKind::component, false);
        }
        template <class... Cs>
        Added& writes() {
            return touches<Cs...>(AccessKind::component, true);
        }
        /// The same for resources.
        template <class... Rs>
        Added& reads_resources() {
            return touches<Rs...>(AccessKind::resource, false);
        }
        template <class... Rs>
        Added& writes_resources() {
            return touches<Rs...>(AccessKind::resource, true);
        }

    private:
        friend class Schedule;
        struct Entry;
        explicit Added(Entry& entry) : entry_{&entry} {}
        template <class... Ts>
        Added& touches(AccessKind kind, bool writes) {
            (touch<Ts>(kind, writes), ...);
            return *this;
        }
        template <class T>
        void touch(AccessKind kind, bool writes) {
            declare(access_part<T>(kind, writes));
            if constexpr (has_enable_bit<T>) {
                if (kind == AccessKind::component) declare(access_part<EnableState<T>>(kind, writes));
            }
        }
        void declare(const AccessPart& part);

        Entry* entry_;
    };

    /// Throws Misuse when there is a system of that name.
    template <class F>
    Added add(std::string name, F system) {
        detail::Declaration declaration;
        auto body = std::make_unique<detail::TypedSystem<F>>(std::move(system), declaration);
        return add(std::move(name), std::move(body), std::move(declaration));
    }
    /// What is added from here on runs after what was added before, and sees its structural changes.
    void sync();

    /// Runs every system once. Throws Misuse when the order contradicts itself, then nothing runs; and what
    /// systems throw, see above. One world after another is fine, two at the same time are not.
    void run(World& world);

    /// The order in which the systems run. Throws Misuse when it contradicts itself.
    [[nodiscard]] const Plan& plan();
    /// In the order of the plan, of the last run in which each system ran; 0, and no thread, before. Valid
    /// until the next add().
    [[nodiscard]] std::span<const SystemTime> times() const { return times_; }
    /// Distinct threads that have worked for this schedule, its caller included.
    [[nodiscard]] std::size_t worker_threads() const { return team_.worker_threads(); }

private:
    Added add(std::string name, std::unique_ptr<detail::SystemBody> body, detail::Declaration declaration);
    void build();
    void run_stages(World& world, Team* team);

    ScheduleOptions options_;
    Team team_;
    std::vector<std::unique_ptr<Added::Entry>> entries_;  ///< as declared
    std::size_t next_stage_ = 0;
    Plan plan_;
    CommandQueue commands_;
    std::vector<std::unique_ptr<detail::Stage>> stages_;
    std::vector<void (*)(World&)> at_start_of_run_;
    std::vector<SystemTime> times_;
    bool built_ = false;
};

}  // namespace rambla::ecs
