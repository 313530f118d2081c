#include "ecs/command_plan.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace rambla::ecs::detail {
namespace {

/// How far ahead of their turn entity records and commands are fetched: they lie anywhere.
constexpr std::size_t k_ahead = 16;

/// An EnableState as it is when its component comes. Copied only, though writes do not say so.
constinit std::byte enabled{0};

}  // namespace

void CommandPlan::make(ArchetypeGraph& graph, const EntityTable& entities, std::span<const Command> commands,
                       CreatedEntities created) {
    clear();
    graph_ = &graph;
    archetypes_before_ = static_cast<std::uint32_t>(graph.size());
    commands_ = commands;
    find_rows(entities, created);
    sort_by_section();
    rows_.reserve(items_.size());
    ranges_.reserve(items_.size());
    group_of_row_.reserve(items_.size());
    gap_rows_.reserve(items_.size());
    for (const Section& section : sections_)
        fold(section);
}

void CommandPlan::clear() {
    items_.clear();
    section_of_item_.clear();
    sections_.clear();
    groups_.clear();
    gaps_.clear();
    rows_.clear();
    ranges_.clear();
    group_of_row_.clear();
    gap_rows_.clear();
    writes_.clear();
    values_.clear();
    sparse_.clear();
    obsolete_.clear();
    dropped_ = 0;
    creations_ = 0;
    section_place_ = 0;
    alike_ = true;
    toggled_from_ = nullptr;
    std::ranges::fill(section_of_archetype_, 0u);
    std::ranges::fill(group_of_archetype_, 0u);  // not all zero after a plan that failed
}

void CommandPlan::find_rows(const EntityTable& entities, CreatedEntities created) {
    const auto creation_key = static_cast<std::uint32_t>(graph_->size());
    // With room for archetypes that the last commands gave birth to, which the next ones find.
    section_of_archetype_.resize(std::bit_ceil(std::max<std::size_t>(graph_->size() + 1, 64)));
    items_.reserve(commands_.size());
    for (std::uint32_t i = 0; i < commands_.size(); ++i) {
        if (i + k_ahead < commands_.size()) entities.prefetch(commands_[i + k_ahead].entity.index);
        const Command& command = commands_[i];
        alike_ = alike_ && command.type == commands_[0].type;
        if (command.type->kind == CommandKind::create) {
            put(creation_key, creations_++, i);
            continue;
        }
        Entity entity = command.entity;
        if (entity.generation == 0) {
            if (entity.index >= created.size()) {
                const std::size_t creation = entity.index - created.size();
                if (creation < creations_) {
                    put(creation_key, static_cast<std::uint32_t>(creation), i);
                } else {
                    drop(command);
                }
                continue;
            }
            entity = created[entity.index];
        }
        if (const EntityRecord* record = entities.find(entity)) {
            put(record->archetype, record->row, i);
        } else {
            drop(command);
        }
    }
}

void CommandPlan::put(std::uint32_t section_key, std::uint32_t row, std::uint32_t command) {
    if (section_place_ == 0 || section_key != section_key_) {
        section_key_ = section_key;
        std::uint32_t& known = section_of_archetype_[section_key];
        if (known == 0) {
            sections_.push_back({.archetype = section_key});
            known = static_cast<std::uint32_t>(sections_.size());
            if (known == 2) section_of_item_.assign(items_.size(), 0);
        }
        section_place_ = known;
    }
    const std::uint32_t place = section_place_;
    Section& section = sections_[place - 1];
    section.sorted = section.sorted && row >= section.highest_row;
    section.highest_row = std::max(section.highest_row, row);
    ++section.count;
    items_.push_back({row, command});
    if (sections_.size() > 1) section_of_item_.push_back(place - 1);
}

void CommandPlan::sort_by_section() {
    scratch_items_.resize(items_.size());
    if (sections_.size() > 1) {
        section_order_.resize(sections_.size());
        std::iota(section_order_.begin(), section_order_.end(), 0u);
        std::ranges::sort(section_order_, {},
                          [&](std::uint32_t place) { return sections_[place].archetype; });
        std::uint32_t next = 0;
        for (std::uint32_t place : section_order_)
            sections_[place].first = std::exchange(next, next + sections_[place].count);
        for (std::size_t i = 0; i < items_.size(); ++i)
            scratch_items_[sections_[section_of_item_[i]].first++] = items_[i];
        std::swap(items_, scratch_items_);
        for (Section& section : sections_)
            section.first -= section.count;
        std::ranges::sort(sections_, {}, &Section::archetype);
    }
    for (const Section& section : sections_) {
        if (section.sorted) continue;
        sort_by_row(std::span{items_}.subspan(section.first, section.count), scratch_items_,
                    section.highest_row);
    }
}

void CommandPlan::fold(const Section& section) {
    Archetype* from = section.archetype < archetypes_before_ ? &(*graph_)[section.archetype] : nullptr;
    if (alike_ && from != nullptr && fold_alike(section, *from)) return;
    const auto first_row = static_cast<std::uint32_t>(rows_.size());
    const auto first_gap = static_cast<std::uint32_t>(gap_rows_.size());
    section_first_group_ = static_cast<std::uint32_t>(groups_.size());
    const std::span<const RowCommand> items = std::span{items_}.subspan(section.first, section.count);
    Repeat repeat;
    for (std::size_t i = 0; i < items.size();) {
        if (i + k_ahead < items.size()) __builtin_prefetch(&commands_[items[i + k_ahead].command]);
        const std::uint32_t row = items[i].row;
        std::size_t end = i + 1;
        while (end < items.size() && items[end].row == row)
            ++end;
        const auto first_write = static_cast<std::uint32_t>(writes_.size());
        Fate fate;
        const CommandType& type = *commands_[items[i].command].type;
        if (end == i + 1 && from != nullptr && !type.beside_columns) {
            fate = fold_single(*from, commands_[items[i].command], repeat);
        } else {
            fate = fold_run(from, items.subspan(i, end - i));
        }
        i = end;
        const std::uint32_t writes = static_cast<std::uint32_t>(writes_.size()) - first_write;
        if (fate.to == from && from != nullptr && writes == 0) continue;
        rows_.push_back(row);
        ranges_.push_back({first_write, writes});
        group_of_row_.push_back(group_to(from, fate.to));
        if (fate.to != from && from != nullptr) gap_rows_.push_back(row);
    }
    group_rows(first_row);
    const auto gaps = static_cast<std::uint32_t>(gap_rows_.size()) - first_gap;
    if (gaps != 0) gaps_.push_back({from, first_gap, gaps});
}

bool CommandPlan::fold_alike(const Section& section, Archetype& from) {
    const CommandType& type = *commands_[0].type;
    if (type.beside_columns) return false;
    const std::span<const RowCommand> items = std::span{items_}.subspan(section.first, section.count);
    for (std::size_t i = 1; i < items.size(); ++i) {
        if (items[i].row == items[i - 1].row) return false;
    }
    const Repeat fate = fate_of_one(from, type);
    if (fate.drops) {
        dropped_ += items.size();
        return true;
    }
    if (fate.to == &from && fate.written == nullptr) return true;
    const std::size_t first_row = rows_.size();
    rows_.resize(first_row + items.size());
    ranges_.resize(rows_.size());
    group_of_row_.resize(rows_.size());
    std::uint32_t* row = rows_.data() + first_row;
    for (const RowCommand& item : items)
        *row++ = item.row;
    PlannedGroup group{&from,        fate.to,        static_cast<std::uint32_t>(first_row),     section.count,
                       fate.written, fate.component, static_cast<std::uint32_t>(values_.size())};
    if (fate.written != nullptr) {
        values_.resize(values_.size() + items.size());
        std::byte** value = values_.data() + group.first_value;
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (i + k_ahead < items.size()) __builtin_prefetch(&commands_[items[i + k_ahead].command]);
            value[i] = commands_[items[i].command].values;
        }
    }
    groups_.push_back(group);
    if (fate.to == &from) return true;
    gaps_.push_back({&from, static_cast<std::uint32_t>(gap_rows_.size()), section.count});
    gap_rows_.insert(gap_rows_.end(), rows_.begin() + static_cast<std::ptrdiff_t>(first_row), rows_.end());
    return true;
}

CommandPlan::Repeat CommandPlan::fate_of_one(Archetype& from, const CommandType& type) {
    if (type.kind == CommandKind::destroy) return {&type, nullptr, nullptr, k_no_component, false};
    const ComponentInfo& info = *type.parts[0].info;
    const ComponentId component = graph_->component(info);
    const bool adds = type.kind == CommandKind::add;
    Archetype* to = from.has(component) != adds ? &toggled(from, component) : &from;
    return {&type, to, adds && info.size != 0 ? &info : nullptr, component, !adds && !from.has(component)};
}

CommandPlan::Fate CommandPlan::fold_single(Archetype& from, const Command& command, Repeat& repeat) {
    if (command.type != repeat.type) repeat = fate_of_one(from, *command.type);
    if (repeat.drops) ++dropped_;
    if (repeat.written != nullptr) writes_.push_back({command.values, repeat.written, repeat.component});
    return {repeat.to};
}

CommandPlan::Fate CommandPlan::fold_run(Archetype* from, std::span<const RowCommand> run) {
    const std::size_t first_write = writes_.size();
    const std::size_t first_sparse = sparse_.size();
    const Entity entity = from != nullptr ? from->entities()[run[0].row] : Entity{run[0].row, 0};
    Archetype* at = from;
    bool ended = false;
    for (const RowCommand& item : run) {
        const Command& command = commands_[item.command];
        if (ended) {
            drop(command);
            continue;
        }
        if (command.type->kind == CommandKind::create) at = &bundle(*command.type);
        if (command.type->kind == CommandKind::destroy) {
            ended = true;
            for (std::size_t i = first_write; i < writes_.size(); ++i)
                forget(writes_[i].value, *writes_[i].info);
            for (std::size_t i = first_sparse; i < sparse_.size(); ++i)
                forget(sparse_[i].value, *sparse_[i].info);
            writes_.resize(first_write);
            sparse_.resize(first_sparse);
        }
        for (const CommandPart& part : command.type->parts) {
            if (part.info->storage == Storage::sparse) {
                fold_sparse(entity, command, part, first_sparse);
                continue;
            }
            const ComponentId component = graph_->component(*part.info);
            const bool held = at->has(component);
            if (part.info->storage == Storage::shared && command.type->kind != CommandKind::remove) {
                at = &graph_->sharing(*at, graph_->intern(*part.info, command.values + part.offset));
                forget(command.values + part.offset, *part.info);
                continue;
            }
            if (command.type->kind == CommandKind::remove) {
                if (held) {
                    at = &toggled(*at, component);
                    unset(component, first_write);
                    if (part.info->companion != nullptr)
                        unset(graph_->component(*part.info->companion), first_write);
                } else {
                    drop(command);
                }
            } else {
                if (!held) {
                    at = &toggled(*at, component);
                    const bool comes_again = from != nullptr && from->has(component);
                    if (const ComponentInfo* companion = part.info->companion; comes_again && companion)
                        set({&enabled, companion, graph_->component(*companion)}, first_write);
                }
                set({command.values + part.offset, part.info, component}, first_write);
            }
        }
    }
    return {ended ? nullptr : at};
}

void CommandPlan::fold_sparse(Entity entity, const Command& command, const CommandPart& part,
                              std::size_t first_sparse) {
    const bool removes = command.type->kind == CommandKind::remove;
    if (removes && !holds_sparse(entity, *part.info, first_sparse)) return drop(command);
    for (std::size_t i = first_sparse; i < sparse_.size(); ++i) {
        if (sparse_[i].info == part.info) forget(std::exchange(sparse_[i].value, nullptr), *part.info);
    }
    sparse_.push_back({entity, removes ? nullptr : command.values + part.offset, part.info, removes});
}

bool CommandPlan::holds_sparse(Entity entity, const ComponentInfo& info, std::size_t first_sparse) const {
    for (std::size_t i = sparse_.size(); i > first_sparse; --i) {
        if (sparse_[i - 1].info == &info) return !sparse_[i - 1].removes;
    }
    const SparseSet* set = graph_->sparse().find(graph_->find_component(info.type_index));
    return set != nullptr && set->find(entity) != SparseSet::k_none;
}

void CommandPlan::drop(const Command& command) {
    ++dropped_;
    if (!command.type->values_end) return;
    for (const CommandPart& part : command.type->parts)
        forget(command.values + part.offset, *part.info);
}

void CommandPlan::set(const PlannedWrite& write, std::size_t first_write) {
    if (write.info->size == 0) return;
    for (std::size_t i = first_write; i < writes_.size(); ++i) {
        if (writes_[i].component != write.component) continue;
        forget(writes_[i].value, *writes_[i].info);
        writes_[i] = write;
        return;
    }
    writes_.push_back(write);
}

void CommandPlan::unset(ComponentId component, std::size_t first_write) {
    for (std::size_t i = first_write; i < writes_.size(); ++i) {
        if (writes_[i].component != component) continue;
        forget(writes_[i].value, *writes_[i].info);
        writes_[i] = writes_.back();
        writes_.pop_back();
        return;
    }
}

void CommandPlan::forget(std::byte* value, const ComponentInfo& info) {
    if (info.destroy != nullptr && value != nullptr) obsolete_.push_back({value, &info});
}

Archetype& CommandPlan::bundle(const CommandType& type) {
    if (&type == bundle_type_) return *bundle_;
    Archetype*& known = bundles_[&type];
    if (known == nullptr) {
        signature_.clear();
        for (const CommandPart& part : type.parts) {
            if (part.info->storage == Storage::column) signature_.push_back(graph_->component(*part.info));
        }
        known = &graph_->with_signature(signature_);
    }
    bundle_type_ = &type;
    bundle_ = known;
    return *known;
}

Archetype& CommandPlan::toggled(Archetype& from, ComponentId component) {
    if (&from == toggled_from_ && component == toggled_component_) return *toggled_to_;
    toggled_to_ = &graph_->toggled(from, component);
    toggled_from_ = &from;
    toggled_component_ = component;
    return *toggled_to_;
}

std::uint32_t CommandPlan::group_to(Archetype* from, Archetype* to) {
    const std::size_t key = to == nullptr ? 0 : to->index() + std::size_t{1};
    if (key >= group_of_archetype_.size()) group_of_archetype_.resize(graph_->size() + 1);
    std::uint32_t& place = group_of_archetype_[key];
    if (place == 0) {
        groups_.push_back({from, to, 0, 0});
        place = static_cast<std::uint32_t>(groups_.size()) - section_first_group_;
    }
    ++groups_[section_first_group_ + place - 1].count;
    return place - 1;
}

void CommandPlan::group_rows(std::uint32_t first_row) {
    const std::span<PlannedGroup> groups = std::span{groups_}.subspan(section_first_group_);
    std::uint32_t next = first_row;
    for (PlannedGroup& group : groups) {
        group.first = std::exchange(next, next + group.count);
        group_of_archetype_[group.to == nullptr ? 0 : group.to->index() + std::size_t{1}] = 0;
    }
    if (groups.size() < 2) return;
    scratch_rows_.assign(rows_.begin() + first_row, rows_.end());
    scratch_ranges_.assign(ranges_.begin() + first_row, ranges_.end());
    for (std::size_t i = 0; i < scratch_rows_.size(); ++i) {
        const std::uint32_t place = groups[group_of_row_[first_row + i]].first++;
        rows_[place] = scratch_rows_[i];
        ranges_[place] = scratch_ranges_[i];
    }
    for (PlannedGroup& group : groups)
        group.first -= group.count;
}

std::size_t CommandPlan::memory_bytes() const {
    const auto bytes = [](const auto& vector) {
        return vector.capacity() * sizeof(vector[0]);
    };
    return bytes(items_) + bytes(section_of_item_) + bytes(scratch_items_) + bytes(sections_) +
           bytes(section_order_) + bytes(section_of_archetype_) + bytes(groups_) +
           bytes(group_of_archetype_) + bytes(gaps_) + bytes(rows_) + bytes(ranges_) + bytes(group_of_row_) +
           bytes(scratch_rows_) + bytes(scratch_ranges_) + bytes(gap_rows_) + bytes(writes_) +
           bytes(values_) + bytes(sparse_) + bytes(obsolete_) + bytes(signature_);
}

}  // namespace rambla::ecs::detail
