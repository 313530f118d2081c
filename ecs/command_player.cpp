#include "ecs/command_player.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "ecs/iteration.h"
#include "ecs/observers.h"
#include "ecs/relocate.h"

namespace rambla::ecs::detail {
namespace {

/// How many values ahead of their turn are fetched: after sorting by rows they lie anywhere.
constexpr std::size_t k_ahead = 16;

}  // namespace

CommandPlayer& CommandPlayer::of(World& world) {
    if (world.player_ == nullptr) world.player_ = std::make_unique<CommandPlayer>(world);
    return *world.player_;
}

Playback CommandPlayer::play(std::span<Commands* const> recordings, std::string_view operation) {
    IterationMark::forbid(world_, operation);
    Observers* const observers = world_.observers_.get();
    if (observers == nullptr) return play_once(recordings);
    Playback playback;
    try {
        playback = play_once(recordings);
    } catch (...) {
        observers->forget();
        throw;
    }
    observers->settle();
    return playback;
}

Playback CommandPlayer::play_once(std::span<Commands* const> recordings) {
    number_placeholders(recordings);
    std::size_t dropped = 0;
    std::size_t next = 0;
    try {
        const CommandType* const type = list_alike(recordings);
        if (type != nullptr && alike_.play(world_.graph_, bulk(), *type, runs_)) {
            give_created_to(recordings);
            return {commands_before_.back(), 0};
        }
        merge(recordings);
        while (next < commands_.size()) {
            const std::size_t end = end_of_singles(next);
            const std::span<const Command> singles = commands_.subspan(next, end - next);
            if (type == nullptr && list_alike(singles) &&
                alike_.play(world_.graph_, bulk(), *singles[0].type, runs_)) {
                next = end;
            } else if (end != next) {
                dropped += play_single(recordings, next, end);
                next = end;
                write_sparse();
                if (world_.observers_ != nullptr) world_.observers_->after_change(created_by_plan());
            }
            if (next == commands_.size()) break;
            play_whole(commands_[next], recording_of(next));
            ++next;
        }
    } catch (...) {
        for (std::size_t i = 0; i < recordings.size(); ++i)
            recordings[i]->forget_from(next - std::min(next, commands_before_[i]));
        throw;
    }
    const Playback playback{commands_.size() - dropped, dropped};
    give_created_to(recordings);
    return playback;
}

const CommandType* CommandPlayer::list_alike(std::span<Commands* const> recordings) {
    if (commands_before_.back() < AlikeMoves::k_fewest || !unobserved()) return nullptr;
    const CommandType* type = nullptr;
    runs_.clear();
    for (const Commands* recording : recordings) {
        if (recording->empty()) continue;
        if (type == nullptr) type = recording->list_.alike_type();
        if (type == nullptr || recording->list_.alike_type() != type) return nullptr;
        recording->list_.append_runs_to(runs_);
    }
    return type;
}

bool CommandPlayer::list_alike(std::span<const Command> commands) {
    if (commands.size() < AlikeMoves::k_fewest || !unobserved()) return false;
    const CommandType& type = *commands[0].type;
    if (!type.is_about_one_column()) return false;
    runs_.clear();
    const std::byte* next = nullptr;
    for (const Command& command : commands) {
        if (command.type != &type) return false;
        if (runs_.empty() || command.values != next)
            runs_.push_back({&command.entity, sizeof(Command), command.values, 0});
        ++runs_.back().count;
        next = command.values + type.stride;
    }
    return true;
}

bool CommandPlayer::unobserved() const {
    return world_.observers_ == nullptr || world_.observers_->idle();
}

std::size_t CommandPlayer::end_of_singles(std::size_t first) const {
    std::size_t end = first;
    while (end < commands_.size() && commands_[end].type->fits == nullptr)
        ++end;
    return end;
}

std::size_t CommandPlayer::play_single(std::span<Commands* const> recordings, std::size_t first,
                                       std::size_t end) {
    plan_.make(world_.graph_, world_.entities_, commands_.subspan(first, end - first), created_);
    prepare();
    if (Observers* const observers = world_.observers_.get(); observers != nullptr) {
        observers->begin();
        observers->note_plan(plan_);
        observers->before_change();
    }
    commit(recordings, first);
    return plan_.dropped();
}

void CommandPlayer::play_whole(const Command& command, std::size_t recording) {
    whole_.clear();
    for (std::size_t i = 0; i < world_.graph_.size(); ++i) {
        Archetype& archetype = world_.graph_[i];
        if (archetype.rows() != 0 && command.type->fits(world_.graph_, archetype))
            whole_.push_back(&archetype);
    }
    Observers* const observers = world_.observers_.get();
    if (observers != nullptr) observers->begin();
    if (command.type->kind == CommandKind::destroy) {
        if (observers != nullptr) {
            observers->note_whole_end(whole_);
            observers->before_change();
        }
        for (Archetype* archetype : whole_)
            bulk().end_all(*archetype);
    } else if (command.type->kind == CommandKind::remove) {
        remove_from_whole(command.type->parts[0]);
    } else {
        resolve_parts(command, created_of(recording));
        add_to_whole(command, command.type->parts[0]);
        destroy_rows(*command.type->parts[0].info, command.values, 1);
        if (observers != nullptr) observers->after_change();
    }
}

void CommandPlayer::add_to_whole(const Command& command, const CommandPart& part) {
    const ComponentId component = world_.graph_.component(*part.info);
    for (Archetype* from : whole_) {
        if (!from->has(component)) BulkRows::reserve_all(*from, world_.graph_.toggled(*from, component));
    }
    if (world_.observers_ != nullptr) world_.observers_->note_whole(whole_, *part.info, true);
    for (Archetype* archetype : whole_) {  // first those that stay, before others come to them
        if (archetype->has(component))
            replace_whole(command, *part.info, *archetype, archetype->column_of(component), 0, true);
    }
    for (Archetype* from : whole_) {
        if (from->has(component)) continue;
        Archetype& to = world_.graph_.toggled(*from, component);
        const std::uint32_t first = bulk().move_all(*from, to);
        replace_whole(command, *part.info, to, to.column_of(component), first, false);
    }
}

void CommandPlayer::replace_whole(const Command& command, const ComponentInfo& info, Archetype& archetype,
                                  ColumnIndex column, std::uint32_t first_row, bool ends_old) noexcept {
    if (column == k_tag_column) return;
    std::byte* first = archetype.columns()[column].at(first_row);
    const std::uint32_t count = archetype.rows() - first_row;
    if (ends_old) destroy_rows(info, first, count);
    command.type->fill(first, count, command.values);
    if (ends_old) bulk().stamp_column(archetype, column, first_row, archetype.rows());
}

void CommandPlayer::remove_from_whole(const CommandPart& part) {
    const ComponentId component = world_.graph_.component(*part.info);
    std::erase_if(whole_, [&](const Archetype* from) { return !from->has(component); });
    for (Archetype* from : whole_)
        BulkRows::reserve_all(*from, world_.graph_.toggled(*from, component));
    if (world_.observers_ != nullptr) {
        world_.observers_->note_whole(whole_, *part.info, false);
        world_.observers_->before_change();
    }
    for (Archetype* from : whole_)
        bulk().move_all(*from, world_.graph_.toggled(*from, component));
}

void CommandPlayer::number_placeholders(std::span<Commands* const> recordings) {
    created_.clear();
    placeholders_.assign(1, 0);
    commands_before_.assign(1, 0);
    for (Commands* recording : recordings) {
        commands_before_.push_back(commands_before_.back() + recording->size());
        placeholders_.push_back(placeholders_.back() + recording->placeholders_);
        recording->created_.clear();
        recording->created_.reserve(recording->placeholders_);
    }
    created_.reserve(placeholders_.back());
}

void CommandPlayer::merge(std::span<Commands* const> recordings) {
    if (recordings.size() == 1) {
        commands_ = recordings[0]->list_.one_by_one();
        return;
    }
    merged_.clear();
    for (std::size_t i = 0; i < recordings.size(); ++i) {
        recordings[i]->list_.append_to(merged_);
        if (placeholders_.back() == 0) continue;
        for (Command& command : std::span{merged_}.last(recordings[i]->size())) {
            if (command.entity.generation != 0) continue;
            const bool known = command.entity.index < recordings[i]->placeholders_;
            command.entity.index = known ? command.entity.index + placeholders_[i] : Entity{}.index;
        }
    }
    commands_ = merged_;
}

void CommandPlayer::prepare() {
    incoming_.assign(world_.graph_.size(), 0);
    for (const PlannedGroup& group : plan_.groups()) {
        if (group.to != nullptr && group.to != group.from) incoming_[group.to->index()] += group.count;
    }
    for (const PlannedGroup& group : plan_.groups()) {
        if (group.to != nullptr) BulkRows::reserve(*group.to, std::exchange(incoming_[group.to->index()], 0));
    }
    reserve_handles();
    std::size_t most_gaps = 0;
    for (const PlannedGaps& gaps : plan_.gaps())
        most_gaps = std::max<std::size_t>(most_gaps, gaps.count);
    fillers_.resize(most_gaps);
    fresh_.reserve(plan_.creations());
}

void CommandPlayer::reserve_handles() {
    std::uint64_t wanted = 0;
    std::uint64_t freed = 0;
    for (const PlannedGroup& group : plan_.groups()) {
        if (group.from == nullptr) {
            wanted += group.to != nullptr ? group.count : 1;  // those that end at once share a slot
        } else if (group.to == nullptr && plan_.creations() != 0) {
            for (std::uint32_t row : plan_.rows(group)) {
                const bool reusable = EntityTable::is_reusable(group.from->entities()[row]);
                freed += reusable ? 1 : 0;
            }
        }
    }
    if (wanted > freed) world_.entities_.reserve(wanted - freed);
}

void CommandPlayer::commit(std::span<Commands* const> recordings, std::size_t first) noexcept {
    const BulkRows bulk = this->bulk();
    for (const PlannedGroup& group : plan_.groups()) {
        if (group.from != nullptr && group.to == nullptr) bulk.end(*group.from, plan_.rows(group));
    }
    create_handles();
    resolve_placeholders(recordings, first);
    for (const ObsoleteValue& obsolete : plan_.obsolete())
        obsolete.info->destroy(obsolete.value, 1);
    auto gaps = plan_.gaps().begin();
    const std::span<const PlannedGroup> groups = plan_.groups();
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const PlannedGroup& group = groups[i];
        const bool last_of_section = i + 1 == groups.size() || groups[i + 1].from != group.from;
        if (group.from == nullptr) {
            append_created(group, bulk);
        } else if (group.from == group.to) {
            replace(group);
        } else if (group.to != nullptr) {
            const bool all_that_leave =
                gaps != plan_.gaps().end() && gaps->archetype == group.from && gaps->count == group.count;
            if (all_that_leave && last_of_section) {  // else values still go to rows where they were
                write(group, bulk.move_and_close(*group.from, plan_.rows(group), *group.to, fillers_));
                ++gaps;
                continue;
            }
            write(group, bulk.move(*group.from, plan_.rows(group), *group.to));
        }
        if (last_of_section && gaps != plan_.gaps().end() && gaps->archetype == group.from) {
            bulk.close_gaps(*group.from, plan_.rows(*gaps), fillers_);
            ++gaps;
        }
    }
}

void CommandPlayer::create_handles() noexcept {
    std::span<const std::uint32_t> doomed;
    for (const PlannedGroup& group : plan_.groups()) {
        if (group.from == nullptr && group.to == nullptr) doomed = plan_.rows(group);
    }
    for (std::uint32_t creation = 0; creation < plan_.creations(); ++creation) {
        created_.push_back(world_.entities_.take(0, 0));
        if (doomed.empty() || doomed.front() != creation) continue;
        world_.entities_.give_back(created_.back().index);
        doomed = doomed.subspan(1);
    }
}

void CommandPlayer::resolve_placeholders(std::span<Commands* const> recordings, std::size_t first) noexcept {
    if (created_.empty()) return;
    std::size_t recording = 0;
    for (std::size_t i = first; i < commands_.size() && commands_[i].type->fits == nullptr; ++i) {
        if (!commands_[i].type->holds_entities) continue;
        while (recording + 1 < recordings.size() && commands_before_[recording + 1] <= i)
            ++recording;
        resolve_parts(commands_[i], created_of(recording));
    }
}

void CommandPlayer::resolve_parts(const Command& command, CreatedEntities created) noexcept {
    for (const CommandPart& part : command.type->parts) {
        if (part.resolve != nullptr) part.resolve(created, command.values + part.offset);
    }
}

void CommandPlayer::append_created(const PlannedGroup& group, const BulkRows& bulk) noexcept {
    if (group.to == nullptr) return;
    fresh_.clear();
    for (std::uint32_t creation : plan_.rows(group))
        fresh_.push_back(created_[created_.size() - plan_.creations() + creation]);
    write(group, bulk.append(*group.to, fresh_));
}

void CommandPlayer::write(const PlannedGroup& group, std::uint32_t first_row) noexcept {
    if (group.only != nullptr) return write_alike(group, first_row);
    const std::span<const PlannedWrite> writes = plan_.writes();
    ComponentId component = k_no_component;
    const Archetype::Column* column = nullptr;
    bool replaces = false;
    std::uint32_t row = first_row;
    for (const WriteRange& range : plan_.write_ranges(group)) {
        if (range.first + k_ahead < writes.size()) __builtin_prefetch(writes[range.first + k_ahead].value);
        for (const PlannedWrite& write : writes.subspan(range.first, range.count)) {
            if (write.component != component) {
                component = write.component;
                column = &group.to->columns()[group.to->column_of(component)];
                replaces =
                    write.info->destroy != nullptr && group.from != nullptr && group.from->has(component);
            }
            if (replaces) write.info->destroy(column->at(row), 1);
            column->take_row(row, write.value);
        }
        ++row;
    }
}

void CommandPlayer::write_alike(const PlannedGroup& group, std::uint32_t first_row) noexcept {
    const Archetype::Column& column = group.to->columns()[group.to->column_of(group.component)];
    const std::span<std::byte* const> values = plan_.values(group);
    std::uint32_t row = first_row;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i + k_ahead < values.size()) __builtin_prefetch(values[i + k_ahead]);
        column.take_row(row++, values[i]);
    }
}

void CommandPlayer::replace(const PlannedGroup& group) noexcept {
    const std::span<const std::uint32_t> rows = plan_.rows(group);
    if (group.only != nullptr) {
        const std::span<std::byte* const> values = plan_.values(group);
        for (std::size_t i = 0; i < rows.size(); ++i)
            replace_row(group, rows[i], group.component, *group.only, values[i]);
        return;
    }
    const std::span<const WriteRange> ranges = plan_.write_ranges(group);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const PlannedWrite& write : plan_.writes().subspan(ranges[i].first, ranges[i].count))
            replace_row(group, rows[i], write.component, *write.info, write.value);
    }
}

void CommandPlayer::replace_row(const PlannedGroup& group, std::uint32_t row, ComponentId component,
                                const ComponentInfo& info, std::byte* value) noexcept {
    const ColumnIndex index = group.to->column_of(component);
    const Archetype::Column& column = group.to->columns()[index];
    destroy_rows(info, column.at(row), 1);
    column.take_row(row, value);
    group.to->stamp_row(index, row, world_.version_);
}

void CommandPlayer::write_sparse() {
    const std::span<const PlannedSparse> all = plan_.sparse();
    std::size_t next = 0;
    try {
        for (; next < all.size(); ++next) {
            const PlannedSparse& sparse = all[next];
            const Entity entity = resolved(created_by_plan(), sparse.entity);
            if (sparse.removes) {
                SparseSet& set = world_.graph_.sparse_set(*sparse.info);
                const std::uint32_t place = set.find(entity);
                if (place != SparseSet::k_none) set.erase(place, world_.version_);
                continue;
            }
            if (sparse.value == nullptr && sparse.info->size != 0) continue;
            void* slot = world_.sparse_slot_for(entity, *sparse.info);
            if (slot != nullptr) relocate_rows(*sparse.info, static_cast<std::byte*>(slot), sparse.value, 1);
        }
    } catch (...) {
        for (const PlannedSparse& sparse : all.subspan(next)) {
            if (sparse.value != nullptr) destroy_rows(*sparse.info, sparse.value, 1);
        }
        throw;
    }
}

std::size_t CommandPlayer::recording_of(std::size_t command) const {
    const auto next = std::ranges::upper_bound(commands_before_, command);
    return static_cast<std::size_t>(next - commands_before_.begin()) - 1;
}

CreatedEntities CommandPlayer::created_of(std::size_t recording) const {
    const std::size_t first = placeholders_[recording];
    const std::size_t end = std::min<std::size_t>(placeholders_[recording + 1], created_.size());
    return CreatedEntities{created_}.subspan(std::min(first, end), end - std::min(first, end));
}

void CommandPlayer::give_created_to(std::span<Commands* const> recordings) {
    for (std::size_t i = 0; i < recordings.size(); ++i) {
        const CreatedEntities created = created_of(i);
        recordings[i]->created_.assign(created.begin(), created.end());
        recordings[i]->forget_from(recordings[i]->size());
    }
}

std::size_t CommandPlayer::memory_bytes() const {
    return sizeof(CommandPlayer) + plan_.memory_bytes() + alike_.memory_bytes() +
           runs_.capacity() * sizeof(CommandRun) + merged_.capacity() * sizeof(Command) +
           (placeholders_.capacity() + fillers_.capacity()) * sizeof(std::uint32_t) +
           (created_.capacity() + fresh_.capacity()) * sizeof(Entity) +
           incoming_.capacity() * sizeof(std::uint64_t) + commands_before_.capacity() * sizeof(std::size_t) +
           whole_.capacity() * sizeof(Archetype*);
}

}  // namespace rambla::ecs::detail
