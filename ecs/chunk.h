#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ecs/archetype_graph.h"
#include "ecs/row_mask.h"
#include "ecs/terms.h"
#include "ecs/version.h"

namespace rambla::ecs {

namespace detail {

/// What all chunks of one walk share.
struct Walk {
    const ArchetypeGraph* graph;
    std::uint32_t version;  ///< of writes
    Since since{};          ///< for Changed terms
};

}  // namespace detail

/// At most 1024 neighbouring rows of one archetype: what a query hands out, one part per term. Spans begin at
/// multiples of 64 bytes and may be read (not written) up to the next multiple of 16 rows.
///     for (auto [entities, positions, velocities] : query.chunks(world)) …
template <class... Terms>
class Chunk {
public:
    using Columns = std::array<ColumnIndex, sizeof...(Terms)>;
    /// What get<I>() returns.
    template <std::size_t I>
    using View = decltype(std::tuple_element_t<I, std::tuple<detail::Term<Terms>...>>::view(
        std::declval<typename std::tuple_element_t<I, std::tuple<detail::Term<Terms>...>>::Cursor>(),
        std::size_t{}));

    /// Columns handed out for writing are stamped with the walk's version.
    Chunk(const detail::Walk& walk, Archetype& archetype, const Columns& columns, std::uint32_t chunk)
        : archetype_{&archetype},
          columns_{&columns},
          chunk_{chunk},
          size_{std::min(archetype.rows() - chunk * k_chunk_rows, k_chunk_rows)},
          cursors_{cursors_of(walk, archetype, columns, chunk, std::index_sequence_for<Terms...>{})} {
        stamp(walk.version, std::index_sequence_for<Terms...>{});
    }

    /// Rows, 1 to 1024.
    [[nodiscard]] std::size_t size() const { return size_; }
    /// All of them.
    [[nodiscard]] RowMask rows() const { return RowMask::first(size_); }

    /// What the I-th term that hands something out gives: the span of a column, empty for an Optional that is
    /// not there; the SparseView of a sparse component; the value of a Shared one.
    template <std::size_t I>
    [[nodiscard]] View<I> get() const {
        return std::tuple_element_t<I, std::tuple<detail::Term<Terms>...>>::view(std::get<I>(cursors_),
                                                                                 size());
    }

    /// Version of the last write to this chunk's column of C, one of the terms, or of rows coming and going,
    /// whichever is later. A chunk handed out for writing counts as written. 0 for an Optional that is not
    /// there.
    template <class C>
    [[nodiscard]] std::uint32_t version() const {
        const ColumnIndex column = (*columns_)[term_of<C>()];
        return column == k_no_column ? 0 : archetype_->version(column, chunk_);
    }

    /// Whether C was written after `seen`, a World::version().
    template <class C>
    [[nodiscard]] bool changed_since(std::uint32_t seen) const {
        const ColumnIndex column = (*columns_)[term_of<C>()];
        return column != k_no_column && is_after(archetype_->version(column, chunk_), seen);
    }

    /// The rows whose C may have been written after `seen`: bit b stands for rows 16b to 16b + 15. Writing by
    /// handle marks rows, handing out a chunk for writing all of them, as do rows that come or go. Exact for
    /// readers that looked within the last four versions that wrote; all that changed otherwise.
    template <class C>
    requires(has_row_mask<std::remove_const_t<C>>) [[nodiscard]] std::uint64_t
        changed_rows(std::uint32_t seen) const {
        const ColumnIndex column = (*columns_)[term_of<C>()];
        return column == k_no_column ? 0 : archetype_->changed_rows(column, chunk_, seen);
    }

    /// Calls f once per row: Entity by value, components by reference, Optional ones by pointer.
    template <class F>
    void each(F&& f) const {
        const Cursors cursors = cursors_;
        const std::size_t rows = size_;
        for (std::size_t row = 0; row < rows; ++row)
            call(f, cursors, row, std::index_sequence_for<Terms...>{});
    }

protected:
    using Cursors = std::tuple<typename detail::Term<Terms>::Cursor...>;

    template <class F, std::size_t... I>
    static void call(F& f, [[maybe_unused]] const Cursors& cursors, [[maybe_unused]] std::size_t row,
                     std::index_sequence<I...>) {
        f(detail::Term<Terms>::argument(std::get<I>(cursors), row)...);
    }
    [[nodiscard]] const Cursors& cursors() const { return cursors_; }

private:
    template <class C>
    static constexpr std::size_t term_of() {
        static_assert((std::is_same_v<typename detail::Term<Terms>::Part, std::remove_const_t<C>> || ...),
                      "not a term of this query that hands something out");
        static_assert(storage_of<std::remove_const_t<C>> == Storage::column,
                      "only columns have a version per chunk");
        constexpr std::array<bool, sizeof...(Terms)> same{
            std::is_same_v<typename detail::Term<Terms>::Part, std::remove_const_t<C>>...};
        std::size_t i = 0;
        while (!same[i])
            ++i;
        return i;
    }

    template <std::size_t... I>
    static Cursors cursors_of([[maybe_unused]] const detail::Walk& walk,
                              [[maybe_unused]] Archetype& archetype, [[maybe_unused]] const Columns& columns,
                              [[maybe_unused]] std::uint32_t chunk, std::index_sequence<I...>) {
        return Cursors{
            detail::Term<Terms>::cursor({*walk.graph, archetype, columns[I], chunk, walk.version})...};
    }

    template <std::size_t... I>
    void stamp([[maybe_unused]] std::uint32_t version, std::index_sequence<I...>) {
        [[maybe_unused]] const auto one = [&](bool stamps, ColumnIndex column) {
            if (stamps && column != k_no_column) archetype_->stamp(column, chunk_, version);
        };
        (one(detail::Term<Terms>::stamps, (*columns_)[I]), ...);
    }

    Archetype* archetype_;
    const Columns* columns_;
    std::uint32_t chunk_;
    std::uint32_t size_;
    Cursors cursors_;
};

/// A chunk of a query that tells rows apart (sparse components, Enabled, Disabled): parts are as long as the
/// chunk, but only the rows in rows() match.
///     for (const auto& chunk : query.chunks(world)) {
///         auto [positions, burning] = chunk;
///         for (std::size_t row : chunk.rows()) positions[row].y += burning[row].heat;
///     }
template <class... Terms>
class FilteredChunk : public Chunk<Terms...> {
public:
    FilteredChunk(const detail::Walk& walk, Archetype& archetype,
                  const typename Chunk<Terms...>::Columns& columns, std::uint32_t chunk, const RowMask& rows)
        : Chunk<Terms...>{walk, archetype, columns, chunk}, rows_{rows} {}

    /// The rows that match, at least one.
    [[nodiscard]] const RowMask& rows() const { return rows_; }

    /// Calls f once per row that matches, as Chunk::each().
    template <class F>
    void each(F&& f) const {
        const auto cursors = this->cursors();
        rows_.for_each([&](std::size_t row) {
            Chunk<Terms...>::call(f, cursors, row, std::index_sequence_for<Terms...>{});
        });
    }

private:
    RowMask rows_;
};

}  // namespace rambla::ecs

template <class... Terms>
struct std::tuple_size<rambla::ecs::Chunk<Terms...>> : std::integral_constant<std::size_t, sizeof...(Terms)> {
};
template <class... Terms>
struct std::tuple_size<rambla::ecs::FilteredChunk<Terms...>>
    : std::integral_constant<std::size_t, sizeof...(Terms)> {};

template <std::size_t I, class... Terms>
struct std::tuple_element<I, rambla::ecs::Chunk<Terms...>> {
    using type = std::remove_reference_t<typename rambla::ecs::Chunk<Terms...>::template View<I>>;
};
template <std::size_t I, class... Terms>
struct std::tuple_element<I, rambla::ecs::FilteredChunk<Terms...>>
    : std::tuple_element<I, rambla::ecs::Chunk<Terms...>> {};
