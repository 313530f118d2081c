#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "ecs/access.h"
#include "ecs/parallel.h"

namespace rambla::ecs {

class CommandQueue;
class World;

/// A chunk's turn in a parallel loop of a system: its place among all jobs of this run of the system. What
/// jobs record is put into this order afterwards, so it does not matter which thread ran them, or when.
struct Job {
    std::uint32_t index = 0;  ///< that place, from 0
    /// Index of the first of those that one thread does in a row: how many are left to chance, but they are
    /// neighbours.
    std::uint32_t run = 0;
};

namespace detail {

/// Something that keeps a place per job for what the jobs record.
class JobLanes {
public:
    /// Makes room for jobs [0, count); called while none runs.
    virtual void open(std::uint32_t count) = 0;

protected:
    ~JobLanes() = default;
};

/// What a system needs while it runs.
struct SystemContext {
    std::string_view name;
    const AccessSet* access = nullptr;
    std::uint32_t place = 0;  ///< in the order of the plan
    World* world = nullptr;
    CommandQueue* commands = nullptr;
    Team* team = nullptr;         ///< null: everything runs on the calling thread
    std::uint32_t job_count = 0;  ///< of this run so far
    std::vector<JobLanes*> lanes;

    /// Room for another loop's jobs; returns the number of the first.
    std::uint32_t open_jobs(std::uint32_t count);
};

/// What a row of a loop costs, measured: decides how many chunks make a job worth handing to a thread, never
/// what the loop computes.
class LoopCost {
public:
    /// Chunks per job; all of them when the loop is too short to be shared.
    [[nodiscard]] std::size_t grain(std::size_t chunks, std::size_t rows, std::size_t threads) const;
    void measured(std::size_t rows, std::uint64_t ns);

private:
    double ns_per_row_ = 5.0;  ///< a guess until the first run
    bool known_ = false;
};

/// Runs `chunk_job(argument, i, first)` for i in [0, count) as the system of `context`, side by side if that
/// pays. `first` is that of the neighbours that one thread does in a row. All run, even when some throw; then
/// the first one's exception, by i, is thrown.
void run_jobs(const SystemContext& context, LoopCost& cost, std::size_t count, std::size_t rows,
              void (*chunk_job)(void*, std::size_t, std::size_t), void* argument);

}  // namespace detail
}  // namespace rambla::ecs
