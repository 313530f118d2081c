#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "ecs/row_mask.h"
#include "ecs/terms.h"
#include "ecs/version.h"

namespace rambla::ecs {

/// Query filter: only entities that have C; hands nothing out. Works for tags and every storage.
template <class C>
struct With {};

/// Query filter: only entities that lack C; hands nothing out.
template <class C>
struct Without {};

/// Query filter: only entities that have at least one of these; hands nothing out.
template <class... Cs>
struct AnyOf {};

/// Query filter: only entities that have C, and have it enabled. Other terms that name C do not ask.
template <class C>
struct Enabled {};

/// Query filter: only entities that have C, and have it disabled.
template <class C>
struct Disabled {};

/// Query filter: only chunks in which one of these was written after the version that the walk is given, rows
/// that came or went included; of a sparse component, only entities whose value was. Entities that have none
/// of them are left out.
template <class... Cs>
struct Changed {};

namespace detail {

template <class C>
struct ColumnWith : TermDefaults {
    static constexpr Need need = Need::required;
};

template <class C>
struct SparseWith : TermDefaults {
    static constexpr bool filters_rows = true;
    static constexpr bool needs_sparse = true;
    static void filter(const ChunkPlace& place, RowMask& rows) {
        keep_those_in(sparse_set_of<C>(place.graph), place.archetype.entities() + place.first_row(), rows);
    }
};

template <class C>
struct Term<With<C>> : std::conditional_t<storage_of<std::remove_const_t<C>> == Storage::sparse,
                                          SparseWith<std::remove_const_t<C>>, ColumnWith<C>> {
    using Part = std::remove_const_t<C>;
    using Column = Part;
};

template <class C>
struct ColumnWithout : TermDefaults {
    static constexpr Need need = Need::excluded;
};

template <class C>
struct SparseWithout : TermDefaults {
    static constexpr bool filters_rows = true;
    static void filter(const ChunkPlace& place, RowMask& rows) {
        keep_those_not_in(sparse_set_of<C>(place.graph), place.archetype.entities() + place.first_row(),
                          rows);
    }
};

template <class C>
struct Term<Without<C>> : std::conditional_t<storage_of<std::remove_const_t<C>> == Storage::sparse,
                                             SparseWithout<std::remove_const_t<C>>, ColumnWithout<C>> {
    using Part = std::remove_const_t<C>;
    using Column = Part;
};

template <class... Cs>
struct Term<AnyOf<Cs...>> : TermDefaults {
    static_assert(sizeof...(Cs) > 0 && k_all_differ<Cs...>, "AnyOf takes different components");
    using Part = AnyOf<Cs...>;
    /// By archetype alone if all are in archetypes; else archetypes that have none may still have rows.
    static constexpr bool filters_rows = ((storage_of<Cs> == Storage::sparse) || ...);

    static bool fits(const ArchetypeGraph& graph, const Archetype& archetype) {
        return filters_rows || ((column_in<Cs>(graph, archetype) != k_no_column) || ...);
    }
    static void filter(const ChunkPlace& place, RowMask& rows) {
        if (((column_in<Cs>(place.graph, place.archetype) != k_no_column) || ...)) return;
        RowMask any;
        (add_those_with<Cs>(place, rows, any), ...);
        rows = any;
    }

private:
    template <class C>
    static void add_those_with(const ChunkPlace& place, RowMask rows, RowMask& any) {
        if constexpr (storage_of<C> == Storage::sparse) {
            Term<With<C>>::filter(place, rows);
            any |= rows;
        }
    }
};

/// Rows whose EnableState of C is as wanted.
template <class C, bool wanted>
struct EnableTerm : TermDefaults {
    static_assert(has_enable_bit<C>, "the component has no enable bit: see component_options");
    static constexpr Need need = Need::required;
    static constexpr bool filters_rows = true;

    static void filter(const ChunkPlace& place, RowMask& rows) {
        const ColumnIndex column = column_in<EnableState<C>>(place.graph, place.archetype);
        const auto* states = reinterpret_cast<const std::uint8_t*>(place.archetype.columns()[column].base);
        const std::size_t count =
            std::min<std::size_t>(place.archetype.rows() - place.first_row(), k_chunk_rows);
        const RowMask enabled = RowMask::of_zeros(states + place.first_row(), count);
        wanted ? rows &= enabled : rows -= enabled;
    }
};

template <class C>
struct Term<Enabled<C>> : EnableTerm<C, true> {
    using Part = Enabled<C>;
    using Column = C;
};

template <class C>
struct Term<Disabled<C>> : EnableTerm<C, false> {
    using Part = Disabled<C>;
    using Column = C;
};

template <class... Cs>
struct Term<Changed<Cs...>> : TermDefaults {
    static_assert(sizeof...(Cs) > 0 && k_all_differ<Cs...>, "Changed takes different components");
    static_assert(((!is_tag<Cs> || storage_of<Cs> == Storage::sparse) && ...) &&
                      ((storage_of<Cs> != Storage::shared) && ...),
                  "only values of an entity's own have change versions");
    using Part = Changed<Cs...>;
    static constexpr bool filters_chunks = true;
    static constexpr bool filters_rows = ((storage_of<Cs> == Storage::sparse) || ...);

    static bool fits(const ArchetypeGraph& graph, const Archetype& archetype) {
        return filters_rows || ((column_in<Cs>(graph, archetype) != k_no_column) || ...);
    }
    /// Whether some chunk of the archetype may have changed.
    static bool admits(const ArchetypeGraph& graph, const Archetype& archetype, Since since) {
        return filters_rows || (column_changed<Cs>(graph, archetype, since) || ...);
    }
    static bool admits(const ArchetypeGraph& graph, const Archetype& archetype, std::uint32_t chunk,
                       Since since) {
        return filters_rows || (chunk_changed<Cs>(graph, archetype, chunk, since) || ...);
    }
    static void filter(const ChunkPlace& place, RowMask& rows, Since since) {
        if ((chunk_changed<Cs>(place.graph, place.archetype, place.chunk, since) || ...)) return;
        RowMask any;
        (add_those_changed<Cs>(place, rows, any, since), ...);
        rows = any;
    }

private:
    template <class C>
    static bool column_changed(const ArchetypeGraph& graph, const Archetype& archetype, Since since) {
        const ColumnIndex column = column_in<C>(graph, archetype);
        return column != k_no_column && is_after(archetype.version(column), since.version);
    }
    template <class C>
    static bool chunk_changed(const ArchetypeGraph& graph, const Archetype& archetype, std::uint32_t chunk,
                              Since since) {
        const ColumnIndex column = column_in<C>(graph, archetype);
        return column != k_no_column && is_after(archetype.version(column, chunk), since.version);
    }
    template <class C>
    static void add_those_changed(const ChunkPlace& place, RowMask rows, RowMask& any, Since since) {
        if constexpr (storage_of<C> == Storage::sparse) {
            const SparseSet* set = sparse_set_of<C>(place.graph);
            if (set == nullptr || set->size() == 0) return;
            const Entity* entities = place.archetype.entities() + place.first_row();
            rows.keep_if([&](std::size_t row) {
                const std::uint32_t found = set->find_alive(entities[row].index);
                return found != SparseSet::k_none && is_after(set->version(found), since.version);
            });
            any |= rows;
        }
    }
};

}  // namespace detail
}  // namespace rambla::ecs
