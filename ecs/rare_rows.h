#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "ecs/archetype.h"
#include "ecs/entity_table.h"
#include "ecs/row_mask.h"
#include "ecs/sparse_set.h"

namespace rambla::ecs::detail {

/// The rows of entities that have a sparse component, for queries that hand out only such rows: where few
/// have it, a walk goes from one of these rows to the next instead of asking all. The same chunks come out in
/// the same order.
class RareRows {
public:
    static constexpr std::size_t k_more_than_any = std::numeric_limits<std::size_t>::max();
    /// Finding the row of an entity, and sorting it in, takes about 80 ns; asking a row whether its entity
    /// has the component 1.3 ns (a million rows, one of two cores of a virtual Xeon).
    static constexpr std::size_t k_rows_per_holder = 64;

    /// A row of an archetype that the query matches.
    struct Row {
        std::uint32_t match;  ///< number of the archetype among the matches
        std::uint32_t row;
        auto operator<=>(const Row&) const = default;
    };

    /// What is left of a walk over single rows, in the order of the archetypes, then of rows.
    struct Walk {
        bool few = false;  ///< else all rows come into question
        const Row* next = nullptr;
        const Row* last = nullptr;
    };

    /// Finds the rows of all who are in `rarest` (null: nobody), unless there are so many that a walk over
    /// all rows is sooner done. The rows are this object's own: walks of other threads, or inside of this
    /// one, find theirs.
    /// @param matches  in the order of archetypes' birth; have an `archetype`
    template <class Match>
    RareRows(const SparseSet* rarest, const EntityTable& entities, std::span<Match> matches) {
        const std::size_t holders = rarest == nullptr ? 0 : rarest->size();
        std::size_t rows = 0;
        for (const Match& match : matches)
            rows += match.archetype->rows();
        if (holders * k_rows_per_holder > rows) return;
        list_ = borrow();
        std::vector<Row>& found = list_->rows;
        found.clear();
        for (std::size_t i = 0; i < holders; ++i) {
            const EntityRecord& record = *entities.find(rarest->entities()[i]);
            const auto match = std::ranges::lower_bound(matches, record.archetype, {}, index_of<Match>);
            if (match != matches.end() && index_of(*match) == record.archetype)
                found.push_back({static_cast<std::uint32_t>(match - matches.begin()), record.row});
        }
        std::ranges::sort(found);
    }

    /// From the first row on; valid as long as this object.
    [[nodiscard]] Walk walk() const {
        if (list_ == nullptr) return {};
        const std::vector<Row>& rows = list_->rows;
        return {true, rows.data(), rows.data() + rows.size()};
    }

    /// Takes the rows of the next chunk off a walk that is not at its end.
    static RowMask take_chunk(Walk& walk) {
        const Row first = *walk.next;
        RowMask rows;
        for (; walk.next != walk.last && walk.next->match == first.match &&
               walk.next->row / k_chunk_rows == first.row / k_chunk_rows;
             ++walk.next)
            rows.set(walk.next->row % k_chunk_rows);
        return rows;
    }

private:
    template <class Match>
    static std::uint32_t index_of(const Match& match) {
        return match.archetype->index();
    }

    struct List {
        std::vector<Row> rows;
        std::unique_ptr<List> next;
    };
    struct GiveBack {
        void operator()(List* list) const noexcept;
    };
    using Lent = std::unique_ptr<List, GiveBack>;

    /// A list that this thread keeps for its walks, so that they do not allocate; a new one if all are lent.
    static Lent borrow();

    /// Those that this thread keeps, the last given back first.
    static thread_local std::unique_ptr<List> spare_;

    Lent list_;  ///< null: all rows come into question
};

}  // namespace rambla::ecs::detail
