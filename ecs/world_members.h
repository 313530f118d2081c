#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "ecs/world.h"

namespace rambla::ecs {

template <class... Cs>
const World::BundlePlace& World::bundle_place() {
    const std::uint32_t bundle = type_index<Bundle<Cs...>>();
    if (bundle < bundles_.size() && bundles_[bundle].archetype != nullptr) return bundles_[bundle];
    return make_bundle_place<Cs...>(bundle);
}

template <class... Cs>
const World::BundlePlace& World::make_bundle_place(std::uint32_t bundle) {
    static_assert(!(detail::k_is_enable_state<Cs> || ...), "an EnableState comes with its component");
    const std::array<ComponentId, sizeof...(Cs)> as_listed{graph_.component(component_info<Cs>())...};
    std::array<ComponentId, sizeof...(Cs)> signature{};
    std::size_t next = 0;
    const auto one = [&](ComponentId component) {
        if (graph_.info(component).storage == Storage::column) signature[next++] = component;
    };
    std::ranges::for_each(as_listed, one);
    Archetype& archetype = graph_.with_signature(std::span{signature}.first(next));
    if (bundles_.size() <= bundle) bundles_.resize(bundle + 1);
    bundles_[bundle].columns = std::make_unique<ColumnIndex[]>(sizeof...(Cs));
    for (std::size_t i = 0; i < as_listed.size(); ++i)
        bundles_[bundle].columns[i] = archetype.column_of(as_listed[i]);
    bundles_[bundle].archetype = &archetype;
    return bundles_[bundle];
}

template <class C>
void World::construct(Archetype& archetype, ColumnIndex column, std::uint32_t row, C& value) noexcept {
    if constexpr (!is_tag<C> && storage_of<C> == Storage::column) {
        std::construct_at(reinterpret_cast<C*>(archetype.columns()[column].base) + row, std::move(value));
    }
}

template <class C>
Archetype* World::with_shared(Archetype* archetype, const C& value) {
    if constexpr (storage_of<C> == Storage::shared)
        return &graph_.sharing(*archetype, graph_.intern(component_info<C>(), &value));
    return archetype;
}

template <class C>
void World::construct_sparse(Entity entity, C& value) {
    if constexpr (storage_of<C> == Storage::sparse) {
        void* slot = sparse_slot_for(entity, component_info<C>());
        if constexpr (!is_tag<C>) std::construct_at(static_cast<C*>(slot), std::move(value));
    }
}

template <class... Cs>
requires(sizeof...(Cs) > 0) Entity World::create(Cs... values) {
    (detail::explain_component<Cs>(), ...);
    static_assert(detail::k_all_differ<Cs...>, "an entity has each component once");
    const BundlePlace& place = bundle_place<Cs...>();
    Archetype* archetype = place.archetype;
    // Shared values lead to a sibling, which has the same columns.
    ((archetype = with_shared(archetype, values)), ...);
    const Created created = create_in(*archetype);
    const ColumnIndex* column = place.columns.get();
    (construct(*archetype, *column++, created.row, values), ...);
    constexpr bool k_has_sparse = ((storage_of<Cs> == Storage::sparse) || ...);
    if constexpr (k_has_sparse) {
        try {
            (construct_sparse(created.entity, values), ...);
        } catch (...) {
            end(created.entity);
            throw;
        }
    }
    if (observers_ != nullptr && (k_has_sparse || archetype->watched().begin)) [[unlikely]]
        announce_new(created.entity, *archetype, k_has_sparse);
    return created.entity;
}

template <Component C>
void World::add(Entity entity, C value) {
    static_assert(!detail::k_is_enable_state<C>, "an EnableState comes with its component");
    if constexpr (storage_of<C> == Storage::shared) return share(entity, component_info<C>(), &value);
    const bool observed = observers_ != nullptr && before_add(entity, component_info<C>());
    void* slot = slot_for(entity, component_info<C>());
    if constexpr (!is_tag<C>) std::construct_at(static_cast<C*>(slot), std::move(value));
    if (observed) after_add();
}

template <Component C>
void World::remove(Entity entity) {
    static_assert(!detail::k_is_enable_state<C>, "an EnableState goes with its component");
    take_away(entity, component_info<C>());
}

template <class C>
const EntityRecord& World::record_of(std::string_view operation, Entity entity) const {
    const EntityRecord* record = entities_.find(entity);
    if (record == nullptr) detail::throw_not_alive(operation, type_name<C>(), entity);
    return *record;
}

template <Component C>
bool World::has(Entity entity) const {
    const EntityRecord& record = record_of<C>("has", entity);
    if constexpr (storage_of<C> == Storage::sparse) return sparse_place<C>(entity) != SparseSet::k_none;
    return graph_[record.archetype].has(graph_.find_component(type_index<C>()));
}

template <Component C>
requires(has_enable_bit<C>) void World::set_enabled(Entity entity, bool enabled) {
    auto* state = find_mut<EnableState<C>>("set_enabled", entity);
    if (state == nullptr) detail::throw_missing("set_enabled", type_name<C>(), entity);
    state->disabled = enabled ? 0 : 1;
}

template <Component C>
requires(has_enable_bit<C>) bool World::enabled(Entity entity) const {
    const auto* state = find<EnableState<C>>("enabled", entity);
    if (state == nullptr) detail::throw_missing("enabled", type_name<C>(), entity);
    return state->disabled == 0;
}

template <class C>
const C* World::find(std::string_view operation, Entity entity) const {
    static_assert(!is_tag<C>, "a tag has no value: ask has<C>()");
    detail::AccessScope::check<C>(*this, AccessKind::component, false);
    const EntityRecord& record = record_of<C>(operation, entity);
    if constexpr (storage_of<C> == Storage::sparse) {
        const std::uint32_t place = sparse_place<C>(entity);
        return place == SparseSet::k_none ? nullptr : reinterpret_cast<C*>(sparse_set<C>()->value(place));
    }
    const Archetype& archetype = graph_[record.archetype];
    if constexpr (storage_of<C> == Storage::shared) {
        const SharedValue* value = archetype.shared(graph_.find_component(type_index<C>()));
        return value == nullptr ? nullptr : &value->as<C>();
    }
    const ColumnIndex column = archetype.column_of(graph_.find_component(type_index<C>()));
    if (column == k_no_column) return nullptr;
    return reinterpret_cast<const C*>(archetype.columns()[column].base) + record.row;
}

template <class C>
C* World::find_mut(std::string_view operation, Entity entity) {
    static_assert(!is_tag<C>, "a tag has no value: ask has<C>()");
    static_assert(storage_of<C> != Storage::shared, "others have this value too: add() another");
    detail::AccessScope::check<C>(*this, AccessKind::component, true);
    const EntityRecord& record = record_of<C>(operation, entity);
    if constexpr (storage_of<C> == Storage::sparse) {
        const std::uint32_t place = sparse_place<C>(entity);
        if (place == SparseSet::k_none) return nullptr;
        sparse_set<C>()->stamp(place, version_);
        return reinterpret_cast<C*>(sparse_set<C>()->value(place));
    }
    Archetype& archetype = graph_[record.archetype];
    const ColumnIndex column = archetype.column_of(graph_.find_component(type_index<C>()));
    if (column == k_no_column) return nullptr;
    archetype.stamp_row(column, record.row, version_);
    return reinterpret_cast<C*>(archetype.columns()[column].base) + record.row;
}

template <Component C>
const C* World::try_get(Entity entity) const {
    return find<C>("try_get", entity);
}

template <Component C>
C* World::try_get_mut(Entity entity) {
    return find_mut<C>("try_get_mut", entity);
}

template <Component C>
const C& World::get(Entity entity) const {
    if (const C* found = find<C>("get", entity)) return *found;
    detail::throw_missing("get", type_name<C>(), entity);
}

template <Component C>
C& World::get_mut(Entity entity) {
    if (C* found = find_mut<C>("get_mut", entity)) return *found;
    detail::throw_missing("get_mut", type_name<C>(), entity);
}

}  // namespace rambla::ecs
