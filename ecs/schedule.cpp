#include "ecs/schedule.h"

#include <algorithm>

namespace rambla::ecs {

struct Schedule::Added::Entry {
    detail::DeclaredSystem system;
    detail::Declaration declaration;
    std::unique_ptr<detail::SystemBody> body;
    bool* built;  ///< the schedule's plan follows from its declarations
};

Schedule::Schedule(ScheduleOptions options) : options_{options} {}

Schedule::~Schedule() = default;

Schedule::Added& Schedule::Added::before(std::string name) {
    entry_->system.before.push_back(std::move(name));
    *entry_->built = false;
    return *this;
}

Schedule::Added& Schedule::Added::after(std::string name) {
    entry_->system.after.push_back(std::move(name));
    *entry_->built = false;
    return *this;
}

void Schedule::Added::declare(const AccessPart& part) {
    entry_->declaration.access.add(part);
    entry_->declaration.limits_world = true;
    *entry_->built = false;
}

Schedule::Added Schedule::add(std::string name, std::unique_ptr<detail::SystemBody> body,
                              detail::Declaration declaration) {
    for (const auto& entry : entries_) {
        if (entry->system.name == name)
            throw Misuse{"ecs: the schedule already has a system \"" + name + "\""};
    }
    auto entry = std::make_unique<Added::Entry>();
    entry->system.name = std::move(name);
    entry->system.stage = next_stage_;
    entry->declaration = std::move(declaration);
    entry->body = std::move(body);
    entry->built = &built_;
    entries_.push_back(std::move(entry));
    built_ = false;
    return Added{*entries_.back()};
}

void Schedule::sync() {
    if (!entries_.empty() && entries_.back()->system.stage == next_stage_) ++next_stage_;
}

const Plan& Schedule::plan() {
    if (!built_) build();
    return plan_;
}

void Schedule::build() {
    std::vector<detail::DeclaredSystem> systems;
    at_start_of_run_.clear();
    for (const auto& entry : entries_) {
        detail::DeclaredSystem system = entry->system;
        system.access = entry->declaration.access;
        if (entry->declaration.takes_world && !entry->declaration.limits_world)
            system.access.add_everything();
        systems.push_back(std::move(system));
        for (void (*const what)(World&) : entry->declaration.at_start_of_run) {
            const bool known =
                std::find(at_start_of_run_.begin(), at_start_of_run_.end(), what) != at_start_of_run_.end();
            if (!known) at_start_of_run_.push_back(what);
        }
    }
    detail::MadePlan made = detail::make_plan(systems);
    stages_.clear();
    plan_ = std::move(made.plan);
    times_.clear();
    std::size_t first_of_stage = 0;
    for (std::size_t i = 0; i < plan_.systems.size(); ++i) {
        const PlannedSystem& system = plan_.systems[i];
        if (stages_.size() == system.stage) {
            stages_.push_back(std::make_unique<detail::Stage>());
            first_of_stage = i;
        }
        std::vector<std::size_t> waits;
        for (const PlannedWait& wait : system.waits)
            waits.push_back(wait.system - first_of_stage);
        const Added::Entry& entry = *entries_[made.declared[i]];
        stages_.back()->add(*entry.body, i, system.name, system.access, entry.declaration.lanes, waits);
        times_.push_back({.name = system.name});
    }
    built_ = true;
}

void Schedule::run(World& world) {
    if (!built_) build();
    world.advance_version();
    for (void (*const what)(World&) : at_start_of_run_)
        what(world);
    for (const auto& entry : entries_)
        entry->body->prepare(world);
    team_.resize(options_.threads != 0 ? options_.threads : Team::allowed_threads());
    Team* const team = team_.threads() > 1 ? &team_ : nullptr;
    std::exception_ptr error;
    team_.enter([&] {
        try {
            run_stages(world, team);
        } catch (...) {
            commands_.clear();
            error = std::current_exception();
        }
    });
    std::size_t next = 0;
    for (const auto& stage : stages_) {
        for (std::size_t i = 0; i < stage->size(); ++i) {
            const detail::Stage::Ran& ran = stage->last_run(i);
            SystemTime& time = times_[next++];
            time = {.name = time.name, .ns = ran.ns, .begin = ran.begin, .thread = ran.thread};
        }
    }
    if (error != nullptr) std::rethrow_exception(error);
}

void Schedule::run_stages(World& world, Team* team) {
    for (const auto& stage : stages_) {
        stage->run(world, commands_, team);
        stage->rethrow();
        commands_.apply(world);
    }
}

}  // namespace rambla::ecs
