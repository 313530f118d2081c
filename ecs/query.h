#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "ecs/chunk.h"
#include "ecs/chunk_range.h"
#include "ecs/filters.h"
#include "ecs/iteration.h"
#include "ecs/rare_rows.h"
#include "ecs/term_access.h"
#include "ecs/terms.h"
#include "ecs/version.h"
#include "ecs/world.h"

namespace rambla::ecs {

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
/// A query must outlive walks over its chunks. It belongs to one thread; but between find_archetypes() and
/// the birth of an archetype, any number of threads may walk or count at once if its terms only read. It may
/// serve several worlds in turn, but remembers only the last.
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

    /// Extends the list of matching archetypes by those born since. Walks do so too; after this, they write
    /// nothing in the query until another archetype is born.
    void find_archetypes(const World& world) {
        if (world.serial_ == world_serial_ && world.graph_.size() == seen_) return;
        extend(world);
    }

    /// The chunks with all matching rows, none empty. Where few entities have a sparse component that the
    /// terms need, the walk goes from one of them to the next instead of over all rows. Does not allocate
    /// unless archetypes were born since, or a walk over few is the longest that this thread made.
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
        return {world, matches_, {&world.graph_, world.version(), since}, rare_walk(world)};
    }

    typename Range::Rare rare_walk([[maybe_unused]] const World& world) {
        if constexpr (Filters::k_needs_sparse) {
            return {Filters::rarest(world.graph_), world.entities_, std::span{matches_}};
        } else {
            return {};
        }
    }

    std::size_t count_rows(const World& world, Since since) {
        const Range range = walk(world, since);
        std::size_t rows = 0;
        if constexpr (Filters::k_rows || Filters::k_chunks) {
            for (auto chunk = range.begin(); chunk != range.end(); ++chunk)
                rows += chunk.row_count();
        } else {
            for (const Match& match : matches_)
                rows += match.archetype->rows();
        }
        return rows;
    }

    void refresh(const World& world) {
        (detail::check_term<Terms>(world), ...);
        find_archetypes(world);
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
