#pragma once

#include <cstdint>
#include <vector>

#include "ecs/command_queue.h"
#include "ecs/parameter.h"

namespace rambla::ecs {

/// System parameter: recordings for the jobs of the system's parallel loops. Their changes are made at the
/// end of the stage, in the order of the jobs.
///     moving.for_each_chunk([&](const auto& chunk, Job job) { … commands.of(job).destroy(entity); });
class JobCommands final : public detail::JobLanes {
public:
    /// Placeholders of its create() hold within this job.
    [[nodiscard]] Commands& of(Job job) {
        Commands*& recording = recordings_[job.run];
        if (recording == nullptr) recording = &context_->commands->recording({context_->place, 1 + job.run});
        return *recording;
    }

    /// For the schedule: a new run of the system.
    void begin(detail::SystemContext& context) {
        context_ = &context;
        recordings_.clear();
    }
    /// For the schedule: see detail::JobLanes.
    void open(std::uint32_t count) override { recordings_.resize(count); }

private:
    detail::SystemContext* context_ = nullptr;
    std::vector<Commands*> recordings_;  ///< by Job::run, so no two threads ask for the same
};

namespace detail {

/// The system's own recording comes before those of its jobs, which count from 1.
template <>
struct Parameter<Commands> : PlainParameter {
    static void declare(Declaration& declaration) { declaration.access.add_commands(); }
    static Commands& fetch(SystemContext& context) { return context.commands->recording({context.place, 0}); }
};

template <>
struct Parameter<JobCommands> : PlainParameter {
    void declare(Declaration& declaration) {
        declaration.access.add_commands();
        declaration.lanes.push_back(&commands);
    }
    JobCommands& fetch(SystemContext& context) {
        commands.begin(context);
        return commands;
    }

    JobCommands commands;
};

}  // namespace detail
}  // namespace rambla::ecs
