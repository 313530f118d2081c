#include "ecs/world.h"

#include <atomic>

#include "ecs/command_player.h"
#include "ecs/observers.h"

namespace rambla::ecs {
namespace {

std::uint64_t next_serial() {
    static std::atomic<std::uint64_t> next{1};
    return next.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

World::World(const WorldOptions& options)
    : entities_{options.max_entities},
      graph_{options.max_rows_per_archetype, options.reserve_address_space, options.first_version - 1,
             options.memory},
      serial_{next_serial()},
      version_{options.first_version} {}

World::~World() = default;

void World::destroy(Entity entity) {
    detail::IterationMark::forbid(*this, "destroy");
    const EntityRecord* record = entities_.find(entity);
    if (record == nullptr) detail::throw_not_alive("destroy", {}, entity);
    Archetype& archetype = graph_[record->archetype];
    const bool may_be_watched = observers_ != nullptr && archetype.watched().end;
    if (!archetype.is_plain() || may_be_watched || !graph_.sparse().all().empty()) [[unlikely]]
        return destroy_any(entity);
    const std::uint32_t row = record->row;
    entities_.give_back(entity.index);
    archetype.erase_plain(
        row, version_, [this](Entity moved, std::uint32_t its_row) { entities_[moved.index].row = its_row; });
}

void World::destroy_any(Entity entity) {
    if (observers_ == nullptr || !observers_->watches_end(graph_[entities_[entity.index].archetype]))
        return end(entity);
    observers_->begin();
    observers_->note_end(entity);
    observers_->before_change();
    end(entity);
    observers_->settle();
}

void World::end(Entity entity) noexcept {
    const EntityRecord& record = entities_[entity.index];
    const std::uint32_t row = record.row;
    const Entity moved = graph_[record.archetype].erase(row, version_);
    if (moved != Entity{}) entities_[moved.index].row = row;
    graph_.sparse().erase_all(entity, version_);
    entities_.give_back(entity.index);
}

void* World::slot_for(Entity entity, const ComponentInfo& info) {
    detail::IterationMark::forbid(*this, "add");
    EntityRecord* record = entities_.find(entity);
    if (record == nullptr) detail::throw_not_alive("add", info.name, entity);
    if (info.storage == Storage::sparse) return sparse_slot_for(entity, info);
    if (info.is_companion) detail::throw_missing("add", info.name, entity);
    if (info.storage == Storage::shared) detail::throw_no_shared_value(info.name);
    const ComponentId component = graph_.component(info);
    Archetype& from = graph_[record->archetype];
    if (!from.has(component)) {
        Archetype& to = move(*record, graph_.toggled(from, component));
        return info.size == 0 ? nullptr : to.columns()[to.column_of(component)].at(record->row);
    }
    if (info.size == 0) return nullptr;
    const ColumnIndex column = from.column_of(component);
    std::byte* slot = from.columns()[column].at(record->row);
    if (info.destroy != nullptr) info.destroy(slot, 1);
    from.stamp_row(column, record->row, version_);
    return slot;
}

void* World::sparse_slot_for(Entity entity, const ComponentInfo& info) {
    SparseSet& set = graph_.sparse_set(info);
    std::uint32_t place = set.find(entity);
    if (place == SparseSet::k_none) return set.value(set.insert(entity, version_));
    if (info.destroy != nullptr) info.destroy(set.value(place), 1);
    set.stamp(place, version_);
    return set.value(place);
}

void World::share(Entity entity, const ComponentInfo& info, const void* value) {
    detail::IterationMark::forbid(*this, "add");
    EntityRecord* record = entities_.find(entity);
    if (record == nullptr) detail::throw_not_alive("add", info.name, entity);
    Archetype& from = graph_[record->archetype];
    Archetype& to = graph_.sharing(from, graph_.intern(info, value));
    if (&to == &from) return;
    const bool observed = observers_ != nullptr && before_add(entity, info);
    move(*record, to);
    if (observed) after_add();
}

void World::take_away(Entity entity, const ComponentInfo& info) {
    detail::IterationMark::forbid(*this, "remove");
    EntityRecord* record = entities_.find(entity);
    if (record == nullptr) detail::throw_not_alive("remove", info.name, entity);
    if (info.storage == Storage::sparse) {
        SparseSet* set = graph_.sparse().find(graph_.find_component(info.type_index));
        const std::uint32_t place = set == nullptr ? SparseSet::k_none : set->find(entity);
        if (place == SparseSet::k_none) detail::throw_missing("remove", info.name, entity);
        const bool observed = observers_ != nullptr && before_remove(entity, info);
        set->erase(place, version_);
        if (observed) observers_->settle();
        return;
    }
    const ComponentId component = graph_.find_component(info.type_index);
    Archetype& from = graph_[record->archetype];
    if (info.is_companion || !from.has(component)) detail::throw_missing("remove", info.name, entity);
    Archetype& to = graph_.toggled(from, component);
    if (observers_ == nullptr) [[likely]] {
        move(*record, to);
        return;
    }
    to.reserve_one();  // so that what observers are told of does not fail
    const bool observed = before_remove(entity, info);
    move(*record, to);
    if (observed) observers_->settle();
}

Observers& World::observers() {
    detail::AccessScope::require_alone(*this, "observers");
    if (observers_ == nullptr) observers_ = std::make_unique<Observers>(*this);
    return *observers_;
}

void World::announce_new(Entity entity, Archetype& archetype, bool has_sparse) {
    if (has_sparse || observers_->watches_begin(archetype)) (void)observers_->announce({&entity, 1});
}

bool World::before_add(Entity entity, const ComponentInfo& info) {
    if (!observers_->watches(info)) return false;
    detail::IterationMark::forbid(*this, "add");
    observers_->begin();
    const EntityRecord* record = entities_.find(entity);
    if (record == nullptr) return false;  // adding says so
    const bool held = holds(entity, *record, info);
    observers_->note(entity, info, held ? Observers::Moment::set : Observers::Moment::add);
    return true;
}

bool World::before_remove(Entity entity, const ComponentInfo& info) {
    if (!observers_->watches(info)) return false;
    observers_->begin();
    observers_->note(entity, info, Observers::Moment::remove);
    observers_->before_change();
    return true;
}

void World::after_add() {
    observers_->after_change();
    observers_->settle();
}

bool World::holds(Entity entity, const EntityRecord& record, const ComponentInfo& info) const {
    const ComponentId component = graph_.find_component(info.type_index);
    if (info.storage != Storage::sparse) return graph_[record.archetype].has(component);
    const SparseSet* set = graph_.sparse().find(component);
    return set != nullptr && set->find(entity) != SparseSet::k_none;
}

void World::age_versions() noexcept {
    graph_.age_versions(version_ - (1u << 30u));
}

Archetype& World::move(EntityRecord& record, Archetype& to) {
    to.reserve_one();
    Archetype& from = graph_[record.archetype];
    const std::uint32_t old_row = record.row;
    record.row = from.move_to(to, old_row, version_);
    record.archetype = to.index();
    const Entity moved = from.close_gap(old_row, version_);
    if (moved != Entity{}) entities_[moved.index].row = old_row;
    return to;
}

void World::compact() {
    detail::IterationMark::forbid(*this, "compact");
    entities_.compact();
    graph_.compact();
}

std::vector<ArchetypeStats> World::archetype_stats() const {
    std::vector<ArchetypeStats> all;
    for (std::size_t i = 0; i < graph_.size(); ++i) {
        const Archetype& archetype = graph_[i];
        const std::size_t rows = archetype.row_memory_bytes();
        const std::size_t own = archetype.memory_bytes() - (archetype.has_reservation() ? rows : 0);
        ArchetypeStats& stats = all.emplace_back(ArchetypeStats{
            {}, archetype.rows(), archetype.capacity(), rows, own, archetype.has_reservation()});
        for (ComponentId component : archetype.signature())
            stats.components.push_back(graph_.info(component).name);
    }
    return all;
}

std::size_t World::memory_bytes() const {
    return sizeof(World) + entities_.memory_bytes() + graph_.memory_bytes() +
           bundles_.capacity() * sizeof(BundlePlace) + resources_.memory_bytes() +
           (player_ != nullptr ? player_->memory_bytes() : 0) +
           (observers_ != nullptr ? observers_->memory_bytes() : 0);
}

std::span<const Entity> detail::announce(World& world, std::span<const Entity> entities) {
    if (world.observers_ == nullptr || entities.empty()) return entities;
    Archetype& archetype = world.graph_[world.entities_[entities.front().index].archetype];
    return world.observers_->watches_begin(archetype) ? world.observers_->announce(entities) : entities;
}

}  // namespace rambla::ecs
