#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>

#include "ecs/archetype_graph.h"
#include "ecs/component.h"
#include "ecs/sparse_view.h"

namespace rambla::ecs {

/// Query term: the component where there is one, an empty span (each(): a null pointer) where not.
/// Optional<const C> only reads.
template <class C>
struct Optional {};

/// Query term: the value of a shared component, as const C&. Entities of a chunk have it in common.
template <class C>
struct Shared {};

namespace detail {

enum class Need { always, required, optional, excluded };

/// Where a chunk of a query lies.
struct ChunkPlace {
    const ArchetypeGraph& graph;
    Archetype& archetype;
    ColumnIndex column;  ///< of the term in question
    std::uint32_t chunk;
    std::uint32_t version;  ///< of writes

    [[nodiscard]] std::size_t first_row() const { return std::size_t{chunk} * k_chunk_rows; }
};

/// Where the archetype has C, k_no_column if it lacks it. Sparse components are in no archetype.
template <class C>
ColumnIndex column_in(const ArchetypeGraph& graph, const Archetype& archetype) {
    return archetype.column_of(graph.find_component(type_index<C>()));
}

/// Null while no entity ever had C.
template <class C>
SparseSet* sparse_set_of(const ArchetypeGraph& graph) {
    return graph.sparse().find(graph.find_component(type_index<C>()));
}

/// What all terms have in common; each states what differs:
///     Part               the component it names; a query names each once
///     need, Column       what an archetype must have; Column is missing if it need have nothing
///     handed_out         has a part in Chunk::get() and each(), by Cursor, cursor(), view() and argument()
///     writes             hands it out for writing
///     stamps             handing out a chunk counts as writing its column
///     filters_rows       narrows down a chunk's rows: filter()
///     filters_chunks     passes archetypes and chunks by: admits()
///     needs_sparse       only rows that are in the sparse set of Part can match
struct TermDefaults {
    static constexpr Need need = Need::always;
    static constexpr bool handed_out = false;
    static constexpr bool writes = false;
    static constexpr bool stamps = false;
    static constexpr bool filters_rows = false;
    static constexpr bool filters_chunks = false;
    static constexpr bool needs_sparse = false;
};

/// A component in a column, const C or C.
template <class T>
struct ColumnTerm : TermDefaults {
    using Part = std::remove_const_t<T>;
    using Column = Part;
    using Cursor = T*;
    static constexpr Need need = Need::required;
    static constexpr bool handed_out = true;
    static constexpr bool writes = !std::is_const_v<T>;
    static constexpr bool stamps = writes;

    static Cursor cursor(const ChunkPlace& place) {
        return reinterpret_cast<T*>(place.archetype.columns()[place.column].base) + place.first_row();
    }
    static std::span<T> view(Cursor first, std::size_t rows) { return {first, rows}; }
    static T& argument(Cursor first, std::size_t row) { return first[row]; }
};

/// A component in a sparse set, const C or C: rows whose entity has none are filtered out.
template <class T>
struct SparseTerm : TermDefaults {
    using Part = std::remove_const_t<T>;
    using Cursor = SparseView<T>;
    static constexpr bool handed_out = true;
    static constexpr bool writes = !std::is_const_v<T>;
    static constexpr bool filters_rows = true;
    static constexpr bool needs_sparse = true;

    static Cursor cursor(const ChunkPlace& place) {
        return {sparse_set_of<Part>(place.graph), place.archetype.entities() + place.first_row(),
                place.version};
    }
    static Cursor view(Cursor cursor, std::size_t) { return cursor; }
    static T& argument(const Cursor& cursor, std::size_t row) { return cursor[row]; }
    static void filter(const ChunkPlace& place, RowMask& rows) {
        keep_those_in(sparse_set_of<Part>(place.graph), place.archetype.entities() + place.first_row(), rows);
    }
};

/// A required component, const C or C, as its storage has it.
template <class T>
struct Term : std::conditional_t<storage_of<std::remove_const_t<T>> == Storage::sparse, SparseTerm<T>,
                                 ColumnTerm<T>> {
    static_assert(Component<std::remove_const_t<T>>,
                  "a term is Entity, a component or one of the terms in terms.h and filters.h");
    static_assert(!is_tag<std::remove_const_t<T>>, "a tag has no column: use With or Without");
    static_assert(storage_of<std::remove_const_t<T>> != Storage::shared,
                  "all rows share one value: use Shared<C>");
};

template <>
struct Term<Entity> : TermDefaults {
    using Part = Entity;
    using Cursor = const Entity*;
    static constexpr bool handed_out = true;

    static Cursor cursor(const ChunkPlace& place) { return place.archetype.entities() + place.first_row(); }
    static std::span<const Entity> view(Cursor first, std::size_t rows) { return {first, rows}; }
    static Entity argument(Cursor first, std::size_t row) { return first[row]; }
};

template <>
struct Term<const Entity> : Term<Entity> {};

template <class T>
struct OptionalColumnTerm : ColumnTerm<T> {
    using typename ColumnTerm<T>::Cursor;
    static constexpr Need need = Need::optional;

    static Cursor cursor(const ChunkPlace& place) {
        return place.column == k_no_column ? nullptr : ColumnTerm<T>::cursor(place);
    }
    static std::span<T> view(Cursor first, std::size_t rows) {
        return {first, first == nullptr ? std::size_t{0} : rows};
    }
    static T* argument(Cursor first, std::size_t row) { return first == nullptr ? nullptr : first + row; }
};

template <class T>
struct OptionalSparseTerm : SparseTerm<T> {
    using typename SparseTerm<T>::Cursor;
    static constexpr bool filters_rows = false;
    static constexpr bool needs_sparse = false;

    static T* argument(const Cursor& cursor, std::size_t row) { return cursor.find(row); }
};

template <class T>
struct Term<Optional<T>> : std::conditional_t<storage_of<std::remove_const_t<T>> == Storage::sparse,
                                              OptionalSparseTerm<T>, OptionalColumnTerm<T>> {
    static_assert(Component<std::remove_const_t<T>> && !is_tag<std::remove_const_t<T>> &&
                      storage_of<std::remove_const_t<T>> != Storage::shared,
                  "Optional takes a component with a value of its own");
};

template <class C>
struct Term<Shared<C>> : TermDefaults {
    static_assert(storage_of<std::remove_const_t<C>> == Storage::shared,
                  "Shared takes a component whose storage is shared");
    using Part = std::remove_const_t<C>;
    using Column = Part;
    using Cursor = const Part*;
    static constexpr Need need = Need::required;
    static constexpr bool handed_out = true;

    static Cursor cursor(const ChunkPlace& place) {
        return &place.archetype.shared(place.graph.find_component(type_index<Part>()))->template as<Part>();
    }
    static const Part& view(Cursor value, std::size_t) { return *value; }
    static const Part& argument(Cursor value, std::size_t) { return *value; }
};

/// The terms that hand something out, in their order, as the parameters of `Target`.
template <template <class...> class Target, class Done, class... Rest>
struct HandedOut;
template <template <class...> class Target, class... Done>
struct HandedOut<Target, std::tuple<Done...>> {
    using Type = Target<Done...>;
};
template <template <class...> class Target, class... Done, class First, class... Rest>
struct HandedOut<Target, std::tuple<Done...>, First, Rest...> {
    using Longer =
        std::conditional_t<Term<First>::handed_out, std::tuple<Done..., First>, std::tuple<Done...>>;
    using Type = typename HandedOut<Target, Longer, Rest...>::Type;
};

}  // namespace detail
}  // namespace rambla::ecs
