#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <vector>

#include "ecs/chunk.h"
#include "ecs/iteration.h"
#include "ecs/terms.h"
#include "ecs/world.h"

namespace rambla::ecs {

/// The archetypes that a query found, and where its columns are in each.
template <class ChunkType>
struct QueryMatch {
    Archetype* archetype;
    typename ChunkType::Columns columns;
};

/// The chunks of a query, for one walk over them: archetypes in the order of their birth, chunks by rows.
/// While it lives, this thread cannot change the world's structure.
template <class ChunkType>
class ChunkRange {
public:
    using Match = QueryMatch<ChunkType>;

    ChunkRange(const World& world, const std::vector<Match>& matches, std::uint32_t version)
        : mark_{world, &matches}, first_{matches.data()}, last_{first_ + matches.size()}, version_{version} {}

    class Iterator {
    public:
        using value_type = ChunkType;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::input_iterator_tag;

        Iterator(const Match* match, const Match* last, std::uint32_t version)
            : match_{match}, last_{last}, version_{version} {
            skip_empty();
        }
        ChunkType operator*() const { return {*match_->archetype, match_->columns, chunk_, version_}; }
        Iterator& operator++() {
            ++chunk_;
            if (chunk_ * k_chunk_rows >= match_->archetype->rows()) {
                chunk_ = 0;
                ++match_;
                skip_empty();
            }
            return *this;
        }
        void operator++(int) { ++*this; }
        bool operator==(std::default_sentinel_t) const { return match_ == last_; }

    private:
        void skip_empty() {
            while (match_ != last_ && match_->archetype->rows() == 0)
                ++match_;
        }

        const Match* match_;
        const Match* last_;
        std::uint32_t chunk_ = 0;
        std::uint32_t version_;
    };

    [[nodiscard]] Iterator begin() const { return {first_, last_, version_}; }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }

private:
    detail::IterationMark mark_;
    const Match* first_;
    const Match* last_;
    std::uint32_t version_;
};

/// Finds the entities with certain components and hands out their columns, a chunk at a time. Terms:
///     Entity                     span<const Entity>
///     const C, C                 span<const C>, span<C>; what is not const counts as written
///     Optional<const C>, <C>     the same where C is there, else an empty span
///     With<C>, Without<C>        only filter
/// Keeps the list of matching archetypes, extended only when an archetype is born: make one and use it again.
/// A query belongs to one thread and must outlive walks over its chunks. It may serve several worlds in turn,
/// but remembers only the last.
template <class... Terms>
class Query {
    static_assert(detail::k_all_differ<typename detail::Term<Terms>::Part...>,
                  "a query names each component once");

public:
    using ChunkType = typename detail::HandedOut<Chunk, std::tuple<>, Terms...>::Type;
    static constexpr bool k_read_only = !(detail::Term<Terms>::writes || ...);

    /// The chunks with all matching rows, none empty. Does not allocate unless archetypes were born since.
    [[nodiscard]] ChunkRange<ChunkType> chunks(World& world) & {
        refresh(world);
        return {world, matches_, world.version()};
    }
    [[nodiscard]] ChunkRange<ChunkType> chunks(const World& world) & requires(k_read_only) {
        refresh(world);
        return {world, matches_, world.version()};
    }

    /// Calls f for every matching entity with what the terms hand out: Entity by value, components by
    /// reference, Optional ones by pointer.
    template <class F>
    void each(World& world, F&& f) {
        for (const auto& chunk : chunks(world))
            chunk.each(f);
    }
    template <class F>
    requires(k_read_only) void each(const World& world, F&& f) {
        for (const auto& chunk : chunks(world))
            chunk.each(f);
    }

    /// Number of matching entities.
    [[nodiscard]] std::size_t count(const World& world) {
        refresh(world);
        std::size_t rows = 0;
        for (const Match& match : matches_)
            rows += match.archetype->rows();
        return rows;
    }

private:
    using Match = QueryMatch<ChunkType>;

    void refresh(const World& world) {
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
        using Part = typename detail::Term<T>::Part;
        if constexpr (std::is_same_v<Part, Entity>) {
            return k_no_column;
        } else {
            return archetype.column_of(world.graph_.find_component(type_index<Part>()));
        }
    }

    template <class T>
    static bool fits(const World& world, const Archetype& archetype) {
        constexpr detail::Need need = detail::Term<T>::need;
        if constexpr (need == detail::Need::required) return column_in<T>(world, archetype) != k_no_column;
        if constexpr (need == detail::Need::excluded) return column_in<T>(world, archetype) == k_no_column;
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
