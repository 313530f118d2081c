#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#include "ecs/chunk.h"
#include "ecs/filters.h"
#include "ecs/iteration.h"
#include "ecs/rare_rows.h"
#include "ecs/row_mask.h"
#include "ecs/terms.h"

namespace rambla::ecs {

class World;

namespace detail {

/// What the terms of a query leave out of the archetypes that it matches.
template <class... Terms>
struct Filters {
    static constexpr bool k_rows = (Term<Terms>::filters_rows || ...);
    static constexpr bool k_chunks = (Term<Terms>::filters_chunks || ...);
    static constexpr bool k_needs_sparse = (Term<Terms>::needs_sparse || ...);

    static bool admits([[maybe_unused]] const Walk& walk, [[maybe_unused]] const Archetype& archetype) {
        return (admitted<Terms>(walk, archetype) && ...);
    }
    static bool admits([[maybe_unused]] const Walk& walk, [[maybe_unused]] const Archetype& archetype,
                       [[maybe_unused]] std::uint32_t chunk) {
        return (admitted<Terms>(walk, archetype, chunk) && ...);
    }
    static RowMask rows(const Walk& walk, Archetype& archetype, std::uint32_t chunk) {
        return rows(walk, archetype, chunk,
                    RowMask::first(std::min(archetype.rows() - chunk * k_chunk_rows, k_chunk_rows)));
    }
    /// Those of `rows` that match.
    static RowMask rows(const Walk& walk, Archetype& archetype, std::uint32_t chunk, RowMask rows) {
        (narrow_down<Terms>(walk, {*walk.graph, archetype, k_no_column, chunk, walk.version}, rows), ...);
        return rows;
    }
    /// The sparse set with the fewest values of those that every matching row is in; null: one is empty.
    static const SparseSet* rarest(const ArchetypeGraph& graph) requires(k_needs_sparse) {
        const SparseSet* rarest = nullptr;
        std::size_t least = RareRows::k_more_than_any;
        (choose_rarer<Terms>(graph, rarest, least), ...);
        return rarest;
    }

private:
    template <class T>
    static void choose_rarer([[maybe_unused]] const ArchetypeGraph& graph,
                             [[maybe_unused]] const SparseSet*& rarest, [[maybe_unused]] std::size_t& least) {
        if constexpr (Term<T>::needs_sparse) {
            const SparseSet* set = sparse_set_of<typename Term<T>::Part>(graph);
            const std::size_t size = set == nullptr ? 0 : set->size();
            if (size < least) rarest = set;
            least = std::min(size, least);
        }
    }
    template <class T, class... Chunk>
    static bool admitted(const Walk& walk, const Archetype& archetype, Chunk... chunk) {
        if constexpr (Term<T>::filters_chunks)
            return Term<T>::admits(*walk.graph, archetype, chunk..., walk.since);
        return true;
    }
    template <class T>
    static void narrow_down(const Walk& walk, const ChunkPlace& place, RowMask& rows) {
        if constexpr (Term<T>::filters_rows && Term<T>::filters_chunks) {
            Term<T>::filter(place, rows, walk.since);
        } else if constexpr (Term<T>::filters_rows) {
            Term<T>::filter(place, rows);
        }
    }
};

/// Stands for what a query does not need.
struct NoRows {};

}  // namespace detail

/// The archetypes that a query found, and where its columns are in each.
template <class ChunkType>
struct QueryMatch {
    Archetype* archetype;
    typename ChunkType::Columns columns;  ///< one per term that hands something out
};

/// The chunks of a query, for one walk over them: archetypes in the order of their birth, chunks by rows.
/// While it lives, this thread cannot change the world's structure.
template <class ChunkType, class Filters>
class ChunkRange {
public:
    using Match = QueryMatch<ChunkType>;

    using Rare = std::conditional_t<Filters::k_needs_sparse, detail::RareRows, detail::NoRows>;

    ChunkRange(const World& world, const std::vector<Match>& matches, const detail::Walk& walk, Rare rare)
        : mark_{world, &matches},
          first_{matches.data()},
          last_{first_ + matches.size()},
          walk_{walk},
          rare_{std::move(rare)} {}

    class Iterator {
    public:
        using value_type = ChunkType;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::input_iterator_tag;

        Iterator(const Match* first, const Match* last, const detail::Walk& walk,
                 [[maybe_unused]] const Rare& rare)
            : first_{first}, match_{first}, last_{last}, walk_{walk} {
            if constexpr (Filters::k_needs_sparse) rare_ = rare.walk();
            settle();
        }
        ChunkType operator*() const {
            if constexpr (Filters::k_rows) {
                return {walk_, *match_->archetype, match_->columns, chunk_, rows_};
            } else {
                return {walk_, *match_->archetype, match_->columns, chunk_};
            }
        }
        /// Rows that match, without handing the chunk out.
        [[nodiscard]] std::size_t row_count() const {
            if constexpr (Filters::k_rows) {
                return rows_.count();
            } else {
                return std::min(match_->archetype->rows() - chunk_ * k_chunk_rows, k_chunk_rows);
            }
        }
        Iterator& operator++() {
            ++chunk_;
            settle();
            return *this;
        }
        void operator++(int) { ++*this; }
        bool operator==(std::default_sentinel_t) const { return match_ == last_; }

    private:
        /// Goes on to the next chunk with rows that match, this one included.
        void settle() {
            if constexpr (Filters::k_needs_sparse) {
                if (rare_.few) return settle_on_rare();
            }
            for (; match_ != last_; ++match_, chunk_ = 0) {
                if (!Filters::admits(walk_, *match_->archetype)) continue;
                for (; chunk_ * k_chunk_rows < match_->archetype->rows(); ++chunk_) {
                    if (has_rows()) return;
                }
            }
        }
        bool has_rows() {
            if (!Filters::admits(walk_, *match_->archetype, chunk_)) return false;
            if constexpr (Filters::k_rows) {
                rows_ = Filters::rows(walk_, *match_->archetype, chunk_);
                return rows_.any();
            }
            return true;
        }

        /// The same where only single rows come into question.
        void settle_on_rare() requires(Filters::k_needs_sparse) {
            while (rare_.next != rare_.last) {
                match_ = first_ + rare_.next->match;
                chunk_ = rare_.next->row / k_chunk_rows;
                const RowMask rare = detail::RareRows::take_chunk(rare_);
                Archetype& archetype = *match_->archetype;
                if (!Filters::admits(walk_, archetype) || !Filters::admits(walk_, archetype, chunk_))
                    continue;
                rows_ = Filters::rows(walk_, archetype, chunk_, rare);
                if (rows_.any()) return;
            }
            match_ = last_;
        }

        const Match* first_;
        const Match* match_;
        const Match* last_;
        detail::Walk walk_;
        [[no_unique_address]] std::conditional_t<Filters::k_needs_sparse, detail::RareRows::Walk,
                                                 detail::NoRows>
            rare_;
        std::uint32_t chunk_ = 0;
        [[no_unique_address]] std::conditional_t<Filters::k_rows, RowMask, detail::NoRows> rows_;
    };

    /// Each walk begins anew; a chunk is valid as long as the range.
    [[nodiscard]] Iterator begin() const { return {first_, last_, walk_, rare_}; }
    /// Where all chunks are done.
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }

private:
    detail::IterationMark mark_;
    const Match* first_;
    const Match* last_;
    detail::Walk walk_;
    [[no_unique_address]] Rare rare_;
};

}  // namespace rambla::ecs
