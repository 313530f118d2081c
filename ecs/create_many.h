#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <type_traits>

#include "ecs/bulk_rows.h"
#include "ecs/iteration.h"
#include "ecs/world.h"
#include "ecs/world_access.h"

namespace rambla::ecs {
namespace detail {

/// The new rows of create_many(): their components are raw memory still.
struct FreshRows {
    Archetype& archetype;
    std::uint32_t first;
    std::uint32_t count;

    template <class C>
    [[nodiscard]] std::span<C> column(const ArchetypeGraph& graph, std::uint32_t from,
                                      std::uint32_t rows) const {
        if constexpr (is_tag<C>) return {};
        const ColumnIndex index = archetype.column_of(graph.find_component(type_index<C>()));
        return {reinterpret_cast<C*>(archetype.columns()[index].at(from)), rows};
    }
    [[nodiscard]] std::span<const Entity> entities() const { return {archetype.entities() + first, count}; }
};

template <class... Cs>
FreshRows fresh_rows(World& world, std::size_t count) {
    static_assert(k_all_differ<Cs...>, "an entity has each component once");
    static_assert(((storage_of<Cs> == Storage::column) && ...), "only columns are filled row by row");
    IterationMark::forbid(world, "create_many");
    ArchetypeGraph& graph = WorldAccess::graph(world);
    std::array<ComponentId, sizeof...(Cs)> signature{graph.component(component_info<Cs>())...};
    Archetype& archetype = graph.with_signature(signature);
    BulkRows::reserve(archetype, count);
    WorldAccess::entities(world).reserve(count);
    const BulkRows bulk{WorldAccess::entities(world), graph.sparse(), world.version()};
    const auto rows = static_cast<std::uint32_t>(count);
    return {archetype, bulk.create(archetype, rows), rows};
}

/// Tells observers of new entities. Returns these, also where observers have moved them.
std::span<const Entity> announce(World& world, std::span<const Entity> entities);

}  // namespace detail

/// Makes `count` entities with copies of these values. Returns them in the order of their rows; the span is
/// valid until the next structural change. Throws CapacityExceeded and changes nothing.
template <Component... Cs>
requires(sizeof...(Cs) > 0) std::span<const Entity> create_many(World& world, std::size_t count,
                                                                const Cs&... values) {
    static_assert(((is_tag<Cs> || std::is_nothrow_copy_constructible_v<Cs>)&&...),
                  "values for many entities are copied, and copying them cannot fail (noexcept)");
    const detail::FreshRows rows = detail::fresh_rows<Cs...>(world, count);
    const ArchetypeGraph& graph = detail::WorldAccess::graph(world);
    const auto copy = [&]<class C>(const C& value) {
        const std::span<C> column = rows.column<C>(graph, rows.first, rows.count);
        std::uninitialized_fill(column.begin(), column.end(), value);
    };
    (copy(values), ...);
    return detail::announce(world, rows.entities());
}

/// Makes `count` entities whose components begin as C{}, then calls fill(span<const Entity>, span<C>...) for
/// one stretch of rows after the other, each within one chunk; tags come as empty spans. What fill throws
/// leaves the entities with the values that they have then. Otherwise as create_many.
template <Component... Cs, class Fill>
requires(sizeof...(Cs) > 0) std::span<const Entity> create_many_with(World& world, std::size_t count,
                                                                     Fill&& fill) {
    static_assert(((is_tag<Cs> || std::is_nothrow_default_constructible_v<Cs>)&&...),
                  "components begin as C{}, and making that cannot fail (noexcept)");
    const detail::FreshRows rows = detail::fresh_rows<Cs...>(world, count);
    const ArchetypeGraph& graph = detail::WorldAccess::graph(world);
    const std::uint32_t end = rows.first + rows.count;
    const auto stretch_end = [&](std::uint32_t row) {
        return std::min(end, (row / k_chunk_rows + 1) * k_chunk_rows);
    };
    // All rows are whole before fill may throw.
    const auto begin_as_default = [](auto column) {
        std::uninitialized_value_construct(column.begin(), column.end());
    };
    (begin_as_default(rows.column<Cs>(graph, rows.first, rows.count)), ...);
    std::exception_ptr error;
    try {
        const detail::IterationMark mark{world, &fill};
        for (std::uint32_t row = rows.first; row < end; row = stretch_end(row)) {
            const std::uint32_t size = stretch_end(row) - row;
            fill(std::span{rows.archetype.entities() + row, size}, rows.column<Cs>(graph, row, size)...);
        }
    } catch (...) {
        error = std::current_exception();
    }
    const std::span<const Entity> made = detail::announce(world, rows.entities());
    if (error != nullptr) std::rethrow_exception(error);
    return made;
}

}  // namespace rambla::ecs
