#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ecs/archetype.h"
#include "ecs/terms.h"

namespace rambla::ecs {

/// At most 1024 neighbouring rows of one archetype: what a query hands out, one span per term. Spans begin at
/// multiples of 64 bytes and may be read (not written) up to the next multiple of 16 rows.
///     for (auto [entities, positions, velocities] : query.chunks(world)) …
template <class... Terms>
class Chunk {
public:
    using Columns = std::array<ColumnIndex, sizeof...(Terms)>;

    /// Columns written to are stamped with `version`.
    Chunk(Archetype& archetype, const Columns& columns, std::uint32_t chunk, std::uint32_t version)
        : archetype_{&archetype},
          columns_{&columns},
          chunk_{chunk},
          size_{std::min(archetype.rows() - chunk * k_chunk_rows, k_chunk_rows)},
          first_{first_of(archetype, columns, chunk)} {
        stamp(version, std::index_sequence_for<Terms...>{});
    }

    /// Rows, 1 to 1024.
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Span of the I-th term that hands something out; empty for an Optional that is not there.
    template <std::size_t I>
    [[nodiscard]] auto get() const {
        auto* first = std::get<I>(first_);
        return std::span{first, first == nullptr ? std::size_t{0} : size()};
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
        return static_cast<std::int32_t>(version<C>() - seen) > 0;
    }

    /// Calls f once per row: Entity by value, components by reference, Optional ones by pointer.
    template <class F>
    void each(F&& f) const {
        each(f, std::index_sequence_for<Terms...>{});
    }

private:
    using Firsts = std::tuple<typename detail::Term<Terms>::Element*...>;

    template <class C>
    static constexpr std::size_t term_of() {
        constexpr std::array<bool, sizeof...(Terms)> same{
            std::is_same_v<typename detail::Term<Terms>::Part, std::remove_const_t<C>>...};
        static_assert((std::is_same_v<typename detail::Term<Terms>::Part, std::remove_const_t<C>> || ...),
                      "not a term of this query that hands something out");
        std::size_t i = 0;
        while (!same[i])
            ++i;
        return i;
    }

    template <class T>
    static typename detail::Term<T>::Element* first_row(Archetype& archetype, ColumnIndex column,
                                                        std::uint32_t chunk) {
        using Element = typename detail::Term<T>::Element;
        const std::size_t row = std::size_t{chunk} * k_chunk_rows;
        if constexpr (std::is_same_v<Element, const Entity>) {
            return archetype.entities() + row;
        } else {
            if (detail::Term<T>::need == detail::Need::optional && column == k_no_column) return nullptr;
            return reinterpret_cast<Element*>(archetype.columns()[column].base) + row;
        }
    }

    static Firsts first_of(Archetype& archetype, const Columns& columns, std::uint32_t chunk) {
        return first_of(archetype, columns, chunk, std::index_sequence_for<Terms...>{});
    }
    template <std::size_t... I>
    static Firsts first_of([[maybe_unused]] Archetype& archetype, [[maybe_unused]] const Columns& columns,
                           [[maybe_unused]] std::uint32_t chunk, std::index_sequence<I...>) {
        return {first_row<Terms>(archetype, columns[I], chunk)...};
    }

    template <std::size_t... I>
    void stamp([[maybe_unused]] std::uint32_t version, std::index_sequence<I...>) {
        [[maybe_unused]] const auto one = [&](bool writes, ColumnIndex column) {
            if (writes && column != k_no_column) archetype_->stamp(column, chunk_, version);
        };
        (one(detail::Term<Terms>::writes, (*columns_)[I]), ...);
    }

    template <class F, std::size_t... I>
    void each(F& f, std::index_sequence<I...>) const {
        [[maybe_unused]] const Firsts first = first_;
        const std::size_t rows = size_;
        for (std::size_t row = 0; row < rows; ++row) {
            f(detail::Term<Terms>::argument(std::get<I>(first), row)...);
        }
    }

    Archetype* archetype_;
    const Columns* columns_;
    std::uint32_t chunk_;
    std::uint32_t size_;
    Firsts first_;
};

}  // namespace rambla::ecs

template <class... Terms>
struct std::tuple_size<rambla::ecs::Chunk<Terms...>> : std::integral_constant<std::size_t, sizeof...(Terms)> {
};

template <std::size_t I, class... Terms>
struct std::tuple_element<I, rambla::ecs::Chunk<Terms...>> {
    using type = std::span<std::remove_pointer_t<
        std::tuple_element_t<I, std::tuple<typename rambla::ecs::detail::Term<Terms>::Element*...>>>>;
};
