#include "ecs/observers.h"

#include <algorithm>
#include <string>

#include "ecs/command_plan.h"
#include "ecs/command_player.h"
#include "ecs/hierarchy.h"
#include "ecs/iteration.h"
#include "ecs/misuse.h"
#include "ecs/world_access.h"

namespace rambla::ecs {

void Observers::end(ObserverId id) {
    detail::IterationMark::forbid(world_, "Observers::end");
    for (Observed& observed : observed_) {
        for (std::vector<Observer>& observers : observed.by_moment) {
            if (std::erase_if(observers, [&](const Observer& observer) { return observer.id == id; }) == 0)
                continue;
            forget_watched();
            return;
        }
    }
    throw Misuse{"ecs: Observers::end: no observer has the number " + std::to_string(id.number)};
}

ObserverId Observers::insert(const ComponentInfo& info, Moment moment, Function call) {
    detail::IterationMark::forbid(world_, "Observers");
    auto observed = std::ranges::find(observed_, &info, &Observed::info);
    if (observed == observed_.end()) {
        observed_.push_back({&info});
        observed = observed_.end() - 1;
    }
    const ObserverId id{next_number_};
    observed->by_moment[static_cast<std::size_t>(moment)].push_back({id, std::move(call)});
    ++next_number_;
    forget_watched();
    return id;
}

Observers::~Observers() {
    for (Hierarchy* hierarchy : followers_)
        hierarchy->followed_ = nullptr;
}

bool Observers::idle() const {
    return size() == 0 && followers_.empty();
}

void Observers::add_follower(Hierarchy& hierarchy) {
    detail::IterationMark::forbid(world_, "Hierarchy::follow_ends");
    followers_.push_back(&hierarchy);
    forget_watched();
}

void Observers::remove_follower(const Hierarchy& hierarchy) noexcept {
    std::erase(followers_, &hierarchy);
    forget_watched();
}

const Watched& Observers::find_watched(Archetype& archetype) const {
    if (archetype.watched().known) return archetype.watched();
    const ArchetypeGraph& graph = detail::WorldAccess::graph(world_);
    Watched watched{.known = true, .begin = false, .end = !followers_.empty()};
    for (const Observed& observed : observed_) {
        const bool sparse = observed.info->storage == Storage::sparse;
        const bool held = archetype.has(graph.find_component(observed.info->type_index));
        watched.begin = watched.begin || (observed.at(Moment::add) && held);
        watched.end = watched.end || (observed.at(Moment::remove) && (held || sparse));
    }
    archetype.set_watched(watched);
    return archetype.watched();
}

void Observers::forget_watched() noexcept {
    const ArchetypeGraph& graph = detail::WorldAccess::graph(world_);
    for (std::size_t i = 0; i < graph.size(); ++i)
        graph[i].set_watched({});
}

bool Observers::watches(const ComponentInfo& info) const {
    return std::ranges::find(observed_, &info, &Observed::info) != observed_.end();
}

void Observers::begin() {
    for (Observed& observed : observed_) {
        observed.component = detail::WorldAccess::graph(world_).find_component(observed.info->type_index);
        for (std::vector<Entity>& due : observed.due)
            due.clear();
    }
}

void Observers::note(Entity entity, const ComponentInfo& info, Moment moment) {
    const auto observed = std::ranges::find(observed_, &info, &Observed::info);
    if (observed != observed_.end()) observed->note(moment, entity);
}

void Observers::note_end(Entity entity) {
    ended_ = true;
    for (Observed& observed : observed_) {
        if (observed.at(Moment::remove) && holds(observed, entity)) observed.note(Moment::remove, entity);
    }
}

void Observers::note_new(std::span<const Entity> entities) {
    for (Observed& observed : observed_) {
        if (!observed.at(Moment::add)) continue;
        for (Entity entity : entities) {
            if (holds(observed, entity)) observed.note(Moment::add, entity);
        }
    }
}

void Observers::note_plan(const detail::CommandPlan& plan) {
    ended_ =
        ended_ || std::ranges::any_of(plan.groups(), [](const detail::PlannedGroup& group) {
            return group.to == nullptr;  // those made and ended in this plan, too: others may hang from them
        });
    for (Observed& observed : observed_) {
        // A component that the plan is the first to speak of has got its number now.
        observed.component = detail::WorldAccess::graph(world_).find_component(observed.info->type_index);
        if (observed.info->storage == Storage::sparse) {
            note_sparse(observed, plan);
        } else {
            note_columns(observed, plan);
        }
    }
}

void Observers::note_columns(Observed& observed, const detail::CommandPlan& plan) {
    const ComponentId component = observed.component;
    for (const detail::PlannedGroup& group : plan.groups()) {
        const bool held = group.from != nullptr && group.from->has(component);
        const bool holds = group.to != nullptr && group.to->has(component);
        if (!held && !holds) continue;
        const Moment moment = !holds ? Moment::remove : held ? Moment::set : Moment::add;
        if (!observed.at(moment)) continue;
        const bool all = moment != Moment::set || group.component == component ||
                         group.from->shared(component) != group.to->shared(component);
        const std::span<const std::uint32_t> rows = plan.rows(group);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto is_written = [&] {
                const detail::WriteRange range = plan.write_ranges(group)[i];
                return std::ranges::any_of(plan.writes().subspan(range.first, range.count),
                                           [&](const auto& write) { return write.component == component; });
            };
            if (!all && (group.only != nullptr || !is_written())) continue;
            observed.note(moment,
                          group.from != nullptr ? group.from->entities()[rows[i]] : Entity{rows[i], 0});
        }
    }
}

void Observers::note_sparse(Observed& observed, const detail::CommandPlan& plan) {
    for (const detail::PlannedGroup& group : plan.groups()) {
        if (group.to != nullptr || group.from == nullptr || !observed.at(Moment::remove)) continue;
        for (std::uint32_t row : plan.rows(group)) {
            const Entity entity = group.from->entities()[row];
            if (holds(observed, entity)) observed.note(Moment::remove, entity);
        }
    }
    const std::span<const detail::PlannedSparse> all = plan.sparse();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].info != observed.info) continue;
        const auto is_replaced = [&] {  // those of one entity follow each other
            for (std::size_t j = i + 1; j < all.size() && all[j].entity == all[i].entity; ++j) {
                if (all[j].info == observed.info) return true;
            }
            return false;
        };
        if (is_replaced()) continue;
        const bool held = all[i].entity.generation != 0 && holds(observed, all[i].entity);
        if (held || !all[i].removes)
            observed.note(all[i].removes ? Moment::remove : held ? Moment::set : Moment::add, all[i].entity);
    }
}

void Observers::note_whole(std::span<Archetype* const> archetypes, const ComponentInfo& info, bool adds) {
    const auto observed = std::ranges::find(observed_, &info, &Observed::info);
    if (observed == observed_.end()) return;
    observed->component = detail::WorldAccess::graph(world_).find_component(info.type_index);
    for (const Archetype* archetype : archetypes) {
        const bool held = archetype->has(observed->component);
        const Moment moment = !adds ? Moment::remove : held ? Moment::set : Moment::add;
        for (std::uint32_t row = 0; row < archetype->rows() && observed->at(moment); ++row)
            observed->note(moment, archetype->entities()[row]);
    }
}

void Observers::note_whole_end(std::span<Archetype* const> archetypes) {
    ended_ = ended_ || !archetypes.empty();
    for (Observed& observed : observed_) {
        if (!observed.at(Moment::remove)) continue;
        const bool sparse = observed.info->storage == Storage::sparse;
        for (const Archetype* archetype : archetypes) {
            if (!sparse && !archetype->has(observed.component)) continue;
            for (Entity entity : std::span{archetype->entities(), archetype->rows()}) {
                if (!sparse || holds(observed, entity)) observed.note(Moment::remove, entity);
            }
        }
    }
}

void Observers::after_change(std::span<const Entity> created) noexcept {
    for (Observed& observed : observed_) {
        for (Entity& entity : observed.due[static_cast<std::size_t>(Moment::add)])
            entity = detail::resolved(created, entity);
    }
    tell(Moment::add);
    tell(Moment::set);
}

std::span<const Entity> Observers::announce(std::span<const Entity> entities) {
    begin();
    note_new(entities);
    announced_.assign(entities.begin(), entities.end());
    after_change();
    settle();
    return announced_;
}

void Observers::settle() {
    try {
        for (std::uint32_t depth = 0;; ++depth) {
            if (error_ != nullptr) std::rethrow_exception(error_);
            tell_followers();
            Commands& recorded = recordings_[recording_];
            if (recorded.empty()) return;
            if (depth == k_cascade_limit) throw_without_end();
            recording_ = 1 - recording_;
            last_recorder_ = nullptr;
            Commands* const playing[]{&recorded};
            detail::CommandPlayer::of(world_).play_once(playing);
        }
    } catch (...) {
        forget();
        throw;
    }
}

void Observers::throw_without_end() const {
    if (last_recorder_ == nullptr)
        throw Misuse{"ecs: Hierarchy::follow_ends: ends of parents cause further ends without end"};
    constexpr std::array<std::string_view, k_moments> k_calls{"on_remove", "on_add", "on_set"};
    throw Misuse{"ecs: " + std::string{k_calls[static_cast<std::size_t>(last_moment_)]} + "<" +
                 std::string{last_recorder_->name} + ">: observers cause changes without end"};
}

void Observers::forget() noexcept {
    for (Commands& recording : recordings_)
        recording.clear();
    error_ = nullptr;
}

void Observers::tell(Moment moment) noexcept {
    try {
        for (const Observed& observed : observed_) {
            for (Entity entity : observed.due[static_cast<std::size_t>(moment)]) {
                if (error_ != nullptr) return;
                tell(observed, moment, entity);
            }
        }
    } catch (...) {
        error_ = std::current_exception();
    }
}

void Observers::tell_followers() {
    if (!ended_) return;
    for (Hierarchy* hierarchy : followers_)
        hierarchy->record_orphans(recordings_[recording_]);
    ended_ = false;
}

void Observers::tell(const Observed& observed, Moment moment, Entity entity) {
    const detail::IterationMark mark{world_, this};
    Commands& commands = recordings_[recording_];
    const void* value = value_of(observed, entity);
    for (const Observer& observer : observed.observers(moment)) {
        const std::size_t before = commands.size();
        observer.call(entity, value, commands);
        if (commands.size() == before) continue;
        last_recorder_ = observed.info;
        last_moment_ = moment;
    }
}

bool Observers::holds(const Observed& observed, Entity entity) const {
    const EntityRecord* record = detail::WorldAccess::entities(world_).find(entity);
    return record != nullptr && world_.holds(entity, *record, *observed.info);
}

const void* Observers::value_of(const Observed& observed, Entity entity) const {
    if (observed.info->size == 0) return nullptr;
    const ArchetypeGraph& graph = detail::WorldAccess::graph(world_);
    const ComponentId component = graph.find_component(observed.info->type_index);
    if (observed.info->storage == Storage::sparse) {
        const SparseSet& set = *graph.sparse().find(component);
        return set.value(set.find(entity));
    }
    const EntityRecord& record = *detail::WorldAccess::entities(world_).find(entity);
    const Archetype& archetype = graph[record.archetype];
    if (observed.info->storage == Storage::shared) return archetype.shared(component)->bytes;
    return archetype.columns()[archetype.column_of(component)].at(record.row);
}

std::size_t Observers::size() const {
    std::size_t count = 0;
    for (const Observed& observed : observed_) {
        for (const std::vector<Observer>& observers : observed.by_moment)
            count += observers.size();
    }
    return count;
}

std::size_t Observers::memory_bytes() const {
    std::size_t bytes = sizeof(Observers) + observed_.capacity() * sizeof(Observed) +
                        announced_.capacity() * sizeof(Entity) + followers_.capacity() * sizeof(Hierarchy*);
    for (const Commands& recording : recordings_)
        bytes += recording.memory_bytes();
    for (const Observed& observed : observed_) {
        for (const std::vector<Observer>& observers : observed.by_moment)
            bytes += observers.capacity() * sizeof(Observer);
        for (const std::vector<Entity>& due : observed.due)
            bytes += due.capacity() * sizeof(Entity);
    }
    return bytes;
}

}  // namespace rambla::ecs
