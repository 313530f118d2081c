#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <vector>

#include "ecs/chunk.h"
#include "ecs/filters.h"
#include "ecs/iteration.h"
#include "ecs/term_access.h"
#include "ecs/terms.h"
#include "ecs/version.h"
#include "ecs/world.h"

namespace rambla::ecs {

namespace detail {

/// What the terms of a query leave out of the archetypes that it matches.
template <class... Terms>
struct Filters {
    static constexpr bool k_rows = (Term<Terms>::filters_rows || ...);
    static constexpr bool k_chunks = (Term<Terms>::filters_chunks || ...);

    static bool admits([[maybe_unused]] const Walk& walk, [[maybe_unused]] const Archetype& archetype) {
        return (admitted<Terms>(walk, archetype) && ...);
    }
    static bool admits([[maybe_unused]] const Walk& walk, [[maybe_unused]] const Archetype& archetype,
                       [[maybe_unused]] std::uint32_t chunk) {
        return (admitted<Terms>(walk, archetype, chunk) && ...);
    }
    static RowMask rows(const Walk& walk, Archetype& archetype, std::uint32_t chunk) {
        RowMask rows = RowMask::first(std::min(archetype.rows() - chunk * k_chunk_rows, k_chunk_rows));
        (narrow_down<Terms>(walk, {*walk.graph, archetype, k_no_column, chunk, walk.version}, rows), ...);
        return rows;
    }

private:
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

    ChunkRange(const World& world, const std::vector<Match>& matches, const detail::Walk& walk)
        : mark_{world, &matches}, first_{matches.data()}, last_{first_ + matches.size()}, walk_{walk} {}

    class Iterator {
    public:
        using value_type = ChunkType;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::input_iterator_tag;

        Iterator(const Match* match, const Match* last, const detail::Walk& walk)
            : match_{match}, last_{last}, walk_{walk} {
            settle();
        }
        ChunkType operator*() const {
            if constexpr (Filters::k_rows) {
                return {walk_, *match_->archetype, match_->columns, chunk_, rows_};
            } else {
                return {walk_, *match_->archetype, match_->columns, chunk_};
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

        const Match* match_;
        const Match* last_;
        detail::Walk walk_;
        std::uint32_t chunk_ = 0;
        [[no_unique_address]] std::conditional_t<Filters::k_rows, RowMask, detail::NoRows> rows_;
    };

    /// Each walk begins anew; a chunk is valid as long as the range.
    [[nodiscard]] Iterator begin() const { return {first_, last_, walk_}; }
    /// Where all chunks are done.
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }

private:
    detail::IterationMark mark_;
    const Match* first_;
    const Match* last_;
    detail::Walk walk_;
};

/// Finds the entities with certain components and hands out their columns, a chunk at a time. Terms:
///     Entity                     span<const Entity>
///     const C, C                 span<const C>, span<C>; what is not const counts as written
///     Optional<const C>, <C>     the same where C is there, else an empty span
///     Shared<C>                  const C&, one for the chunk
///     With, Without, AnyOf, Changed, Enabled, Disabled      only filter
/// A sparse component is handed out as a SparseView instead of a span. Where sparse components, Enabled or
/// Disabled tell rows apart, chunks are FilteredChunks: only the rows in their rows() match.
///
/// Keeps the list of matching archetypes, extended only when an archetype is born: make one and use it again.
/// A query belongs to one thread and must outlive walks over its chunks. It may serve several worlds in turn,
/// but remembers only the last.
template <class... Terms>
class Query {
    static_assert(detail::k_all_differ<typename detail::Term<Terms>::Part...>,
                  "a query names each component once");
    using Filters = detail::Filters<Terms...>;

public:
    using ChunkType =
        std::conditional_t<Filters::k_rows,
                           typename detail::HandedOut<FilteredChunk, std::tuple<>, Terms...>::Type,
                           typename detail::HandedOut<Chunk, std::tuple<>, Terms...>::Type>;
    using Range = ChunkRange<ChunkType, Filters>;
    /// Whether nothing is handed out for writing: then a const World will do.
    static constexpr bool k_read_only = !(detail::Term<Terms>::writes || ...);
    /// With Changed terms, walks need to know since when.
    static constexpr bool k_asks_changes = Filters::k_chunks;

    /// The chunks with all matching rows, none empty. Does not allocate unless archetypes were born since.
    [[nodiscard]] Range chunks(World& world) & requires(!k_asks_changes) { return walk(world, {}); }
    [[nodiscard]] Range chunks(const World& world) & requires(k_read_only && !k_asks_changes) {
        return walk(world, {});
    }
    [[nodiscard]] Range chunks(World& world, Since since) & requires(k_asks_changes) {
        return walk(world, since);
    }
    [[nodiscard]] Range chunks(const World& world, Since since) & requires(k_read_only&& k_asks_changes) {
        return walk(world, since);
    }

    /// Calls f for every matching entity with what the terms hand out: Entity by value, components by
    /// reference, Optional ones by pointer.
    template <class F>
    requires(!k_asks_changes) void each(World& world, F&& f) {
        for (const auto& chunk : walk(world, {}))
            chunk.each(f);
    }
    template <class F>
    requires(k_read_only && !k_asks_changes) void each(const World& world, F&& f) {
        for (const auto& chunk : walk(world, {}))
            chunk.each(f);
    }
    template <class F>
    requires(k_asks_changes) void each(World& world, Since since, F&& f) {
        for (const auto& chunk : walk(world, since))
            chunk.each(f);
    }
    template <class F>
    requires(k_read_only&& k_asks_changes) void each(const World& world, Since since, F&& f) {
        for (const auto& chunk : walk(world, since))
            chunk.each(f);
    }

    /// Number of matching entities. Hands nothing out, so nothing counts as written.
    [[nodiscard]] std::size_t count(const World& world) requires(!k_asks_changes) {
        return count_rows(world, {});
    }
    [[nodiscard]] std::size_t count(const World& world, Since since) requires(k_asks_changes) {
        return count_rows(world, since);
    }

private:
    using Match = QueryMatch<ChunkType>;

    Range walk(const World& world, Since since) {
        refresh(world);
        return {world, matches_, {&world.graph_, world.version(), since}};
    }

    std::size_t count_rows(const World& world, Since since) {
        refresh(world);
        const detail::Walk walk{&world.graph_, world.version(), since};
        std::size_t rows = 0;
        for (const Match& match : matches_) {
            Archetype& archetype = *match.archetype;
            if constexpr (!Filters::k_rows && !Filters::k_chunks) {
                rows += archetype.rows();
                continue;
            }
            if (!Filters::admits(walk, archetype)) continue;
            for (std::uint32_t chunk = 0; chunk * k_chunk_rows < archetype.rows(); ++chunk) {
                if (Filters::admits(walk, archetype, chunk))
                    rows += Filters::rows(walk, archetype, chunk).count();
            }
        }
        return rows;
    }

    void refresh(const World& world) {
        (detail::check_term<Terms>(world), ...);
        if (world.serial_ == world_serial_ && world.graph_.size() == seen_) return;
        extend(world);
    }

    void extend(const World& world) {
        if (world.serial_ != world_serial_) {
            detail::IterationMark::forbid_through(&matches_, "Query of one world used for another");
            matches_.clear();
            seen_ = 0;
            world_serial_ = world.serial_;
        }
        for (; seen_ < world.graph_.size(); ++seen_) {
            Archetype& archetype = world.graph_[seen_];
            if ((fits<Terms>(world, archetype) && ...))
                matches_.push_back({&archetype, columns_in(world, archetype)});
        }
    }

    template <class T>
    static ColumnIndex column_in(const World& world, const Archetype& archetype) {
        using Term = detail::Term<T>;
        if constexpr (Term::need == detail::Need::always) {
            return k_no_column;
        } else {
            return detail::column_in<typename Term::Column>(world.graph_, archetype);
        }
    }

    template <class T>
    static bool fits(const World& world, const Archetype& archetype) {
        using Term = detail::Term<T>;
        if constexpr (requires { Term::fits(world.graph_, archetype); })
            return Term::fits(world.graph_, archetype);
        if constexpr (Term::need == detail::Need::required)
            return column_in<T>(world, archetype) != k_no_column;
        if constexpr (Term::need == detail::Need::excluded)
            return column_in<T>(world, archetype) == k_no_column;
        return true;
    }

    static typename ChunkType::Columns columns_in(const World& world, const Archetype& archetype) {
        typename ChunkType::Columns columns{};
        std::size_t next = 0;
        [[maybe_unused]] const auto one = [&](bool handed_out, ColumnIndex column) {
            if (handed_out) columns[next++] = column;
        };
        (one(detail::Term<Terms>::handed_out, column_in<Terms>(world, archetype)), ...);
        return columns;
    }

    std::vector<Match> matches_;
    std::size_t seen_ = 0;  ///< archetypes looked at
    std::uint64_t world_serial_ = 0;
};

}  // namespace rambla::ecs
