#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "ecs/world.h"

namespace rambla::ecs {
namespace detail {

/// How many entities ahead their rows are fetched into the cache, and twice as many their records: enough to
/// hide a miss to memory behind the work on the entities between (some 100 ns, a few ns each).
inline constexpr std::size_t k_rows_ahead = 16;

}  // namespace detail

/// Three places in the list at a time, so that the misses of many entities overlap:
///     … i ──────────── i + rows ahead ──────────── i + records ahead …
///     call f           read record, fetch row      fetch record
template <class C, class F>
void World::for_many(std::string_view operation, std::span<const Entity> entities, F& f) const {
    using Part = std::remove_const_t<C>;
    detail::AccessScope::check<Part>(*this, AccessKind::component, !std::is_const_v<C>);
    const detail::IterationMark mark{*this, &entities};
    const ComponentId component = graph_.find_component(type_index<Part>());
    std::uint32_t archetype = k_no_archetype;  // the one that column and base belong to
    ColumnIndex column = k_no_column;
    C* base = nullptr;
    const auto locate = [&](Entity entity) {
        const EntityRecord& record = record_of<Part>(operation, entity);
        if (record.archetype != archetype) {
            column = graph_[record.archetype].column_of(component);
            if (column == k_no_column) detail::throw_missing(operation, type_name<Part>(), entity);
            archetype = record.archetype;
            base = reinterpret_cast<C*>(graph_[archetype].columns()[column].base);
        }
        if constexpr (!std::is_const_v<C>) graph_[archetype].stamp_row(column, record.row, version_);
        __builtin_prefetch(base + record.row, std::is_const_v<C> ? 0 : 1);
        return base + record.row;
    };
    std::array<C*, detail::k_rows_ahead> located{};
    const std::size_t count = entities.size();
    const auto fetch_and_locate = [&](std::size_t i) {  // for the one whose record was fetched before
        if (i + detail::k_rows_ahead < count) entities_.prefetch(entities[i + detail::k_rows_ahead]);
        if (i < count) located[i % detail::k_rows_ahead] = locate(entities[i]);
    };
    for (std::size_t i = 0; i < std::min(count, detail::k_rows_ahead); ++i)
        entities_.prefetch(entities[i]);
    for (std::size_t i = 0; i < detail::k_rows_ahead; ++i)
        fetch_and_locate(i);
    for (std::size_t i = 0; i < count; ++i) {
        C& value = *located[i % detail::k_rows_ahead];
        fetch_and_locate(i + detail::k_rows_ahead);
        f(i, value);
    }
}

template <Component C, class F>
void World::get_many(std::span<const Entity> entities, F&& f) const {
    static_assert(!is_tag<C>, "a tag has no value: ask has<C>()");
    if constexpr (storage_of<C> == Storage::column) {
        for_many<const C>("get_many", entities, f);
    } else {
        for (std::size_t i = 0; i < entities.size(); ++i)
            f(i, get<C>(entities[i]));
    }
}

template <Component C, class F>
void World::get_many_mut(std::span<const Entity> entities, F&& f) {
    static_assert(!is_tag<C>, "a tag has no value: ask has<C>()");
    if constexpr (storage_of<C> == Storage::column) {
        for_many<C>("get_many_mut", entities, f);
    } else {
        for (std::size_t i = 0; i < entities.size(); ++i)
            f(i, get_mut<C>(entities[i]));
    }
}

}  // namespace rambla::ecs
