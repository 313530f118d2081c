#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ecs/parameter.h"
#include "ecs/world_access.h"

namespace rambla::ecs {

/// Resource: what happened in this step and the one before, a column of E each, oldest first. A schedule that
/// writes E begins a step with each run: what is older than the step before is forgotten then.
template <class E>
class Events {
public:
    /// Written in the step before this one, oldest first. Valid until the next write.
    [[nodiscard]] std::span<const E> of_last_step() const { return columns_[0]; }
    /// Written since the step began, oldest first. Valid until the next write.
    [[nodiscard]] std::span<const E> of_this_step() const { return columns_[1]; }

    /// For code outside of schedules; systems write through an EventWriter.
    void emit(E event) { columns_[1].push_back(std::move(event)); }
    /// Emits all of them, in their order, and leaves `events` empty, with its memory.
    void append(std::vector<E>& events) {
        for (E& event : events)
            columns_[1].push_back(std::move(event));
        events.clear();
    }
    /// Forgets what was written in the step before the one that ends. Schedules that write E do it.
    void begin_step() {
        first_ += columns_[0].size();
        columns_[0].clear();
        std::swap(columns_[0], columns_[1]);
    }

    /// Number of the oldest event that is still here; events are numbered from 0 in the order of writing.
    [[nodiscard]] std::uint64_t first() const { return first_; }
    /// Number that the next event gets.
    [[nodiscard]] std::uint64_t end() const { return first_ + columns_[0].size() + columns_[1].size(); }
    /// The events of one step from a number on.
    [[nodiscard]] std::span<const E> of_last_step(std::uint64_t from) const {
        return since(columns_[0], first_, from);
    }
    [[nodiscard]] std::span<const E> of_this_step(std::uint64_t from) const {
        return since(columns_[1], first_ + columns_[0].size(), from);
    }

private:
    static std::span<const E> since(const std::vector<E>& column, std::uint64_t first, std::uint64_t from) {
        const std::uint64_t skipped = from <= first ? 0 : from - first;
        if (skipped >= column.size()) return {};
        return std::span<const E>{column}.subspan(static_cast<std::size_t>(skipped));
    }

    std::array<std::vector<E>, 2> columns_;
    std::uint64_t first_ = 0;
};

/// System parameter: the events that this system has not read yet. A system that runs in each step reads each
/// event once: in the step in which it was written if the writer ran before it, else in the next. In another
/// world than the last time it begins with the oldest event that is there.
template <class E>
class EventReader {
public:
    EventReader(std::span<const E> of_last_step, std::span<const E> of_this_step)
        : of_last_step_{of_last_step}, of_this_step_{of_this_step} {}

    /// Those of the step before that this system has not read, oldest first. Valid while the system runs.
    [[nodiscard]] std::span<const E> of_last_step() const { return of_last_step_; }
    /// Those of this step that it has not read.
    [[nodiscard]] std::span<const E> of_this_step() const { return of_this_step_; }
    /// Number of both.
    [[nodiscard]] std::size_t size() const { return of_last_step_.size() + of_this_step_.size(); }
    /// Whether there is nothing to read.
    [[nodiscard]] bool empty() const { return size() == 0; }
    /// Calls f(event), oldest first.
    template <class F>
    void each(F&& f) const {
        for (const E& event : of_last_step_)
            f(event);
        for (const E& event : of_this_step_)
            f(event);
    }

private:
    std::span<const E> of_last_step_;
    std::span<const E> of_this_step_;
};

/// System parameter: writes events. They can be read once the system has returned: first those that it wrote
/// itself, then those of its jobs in the order of the jobs. If it throws, none of them.
template <class E>
class EventWriter final : public detail::JobLanes {
public:
    /// From the system itself.
    void emit(E event) { own_.push_back(std::move(event)); }
    /// From a job of a parallel loop of this system.
    void emit(Job job, E event) { lanes_[job.index].push_back(std::move(event)); }

    /// For the schedule: see detail::JobLanes.
    void open(std::uint32_t count) override {
        if (lanes_.size() < count) lanes_.resize(count);
        opened_ = count;
    }
    /// For the schedule: hands over what was written.
    void finish(Events<E>& events) {
        events.append(own_);
        for (std::uint32_t i = 0; i < opened_; ++i)
            events.append(lanes_[i]);
        opened_ = 0;
    }
    /// For the schedule: drops what was written.
    void forget() noexcept {
        own_.clear();
        for (std::vector<E>& lane : lanes_)
            lane.clear();
        opened_ = 0;
    }

private:
    std::vector<E> own_;
    std::vector<std::vector<E>> lanes_;
    std::uint32_t opened_ = 0;
};

namespace detail {

template <class E>
Events<E>& events_of(World& world) {
    return world.has_resource<Events<E>>() ? world.resource<Events<E>>() : world.set_resource(Events<E>{});
}

template <class E>
struct Parameter<EventReader<E>> : PlainParameter {
    static void declare(Declaration& declaration) {
        declaration.access.add(access_part<Events<E>>(AccessKind::resource, false));
    }
    static void prepare(World& world) { events_of<E>(world); }
    EventReader<E> fetch(SystemContext& context) {
        const auto& events = static_cast<const World*>(context.world)->resource<Events<E>>();
        if (seen_world != WorldAccess::serial(*context.world)) {
            seen_world = WorldAccess::serial(*context.world);
            next_unread = 0;
        }
        const std::uint64_t from = std::exchange(next_unread, events.end());
        return {events.of_last_step(from), events.of_this_step(from)};
    }

    std::uint64_t next_unread = 0;
    std::uint64_t seen_world = 0;  ///< its serial
};

template <class E>
struct Parameter<EventWriter<E>> : PlainParameter {
    void declare(Declaration& declaration) {
        declaration.access.add(access_part<Events<E>>(AccessKind::resource, true));
        declaration.lanes.push_back(&writer);
        declaration.at_start_of_run.push_back([](World& world) { events_of<E>(world).begin_step(); });
    }
    EventWriter<E>& fetch(SystemContext&) { return writer; }
    void finish(SystemContext& context) { writer.finish(events_of<E>(*context.world)); }
    void forget() noexcept { writer.forget(); }

    EventWriter<E> writer;
};

}  // namespace detail
}  // namespace rambla::ecs
