#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "ecs/access_scope.h"
#include "ecs/filters.h"
#include "ecs/parallel.h"
#include "ecs/propagation_changes.h"
#include "ecs/terms.h"
#include "ecs/world_access.h"

namespace rambla::ecs {

/// Carries results down the trees of Parent: a root's result follows from its Local, a child's from its
/// parent's Result and its own Local.
///
///     Propagation<const LocalTransform, WorldTransform> propagate;
///     propagate(world, [](const LocalTransform& local) { return …; },
///               [](const WorldTransform& parent, const LocalTransform& local) { return …; });
///
/// Members are the entities with Local, Result and what else `Terms` require (With<C>, C, const C,
/// Optional<C>; their columns are handed to both functions behind the Local, Optional ones as pointers). A
/// Local or term that is not const may be written by the functions, each entity's own only. A Local that they
/// give another value counts as written after the call: it is visited again, until it stays.
///
/// Visits only what may have changed: members in chunks whose Local, Parent or terms were written or whose
/// rows came or went since the last time, and what hangs from members whose result is another one than
/// before, bit by bit. A Result that others overwrite stays as it is until then.
///
/// A parent that is no member but has a Result counts as it is. Members rest, keeping their Result, while
/// they hang from a dead parent, from one without Result, or in a ring.
///
/// Works on segments of the order in parallel; results do not depend on the number of threads. The functions
/// are called from several threads at once. Allocates nothing unless rows came or went or parents changed.
/// Each call ends the world's version, to tell what was written before it from what comes later; in a system
/// that shares the world with others it cannot, and visits what was written in the schedule's run a second
/// time in the next one. What a function throws comes out; results then are partly new, and the next call
/// starts over.
template <class Local, class Result, class... Terms>
class Propagation {
    static_assert(Component<std::remove_const_t<Local>> && Component<Result>);
    static_assert(storage_of<std::remove_const_t<Local>> == Storage::column &&
                  storage_of<Result> == Storage::column);
    static_assert(std::is_const_v<Local> || std::is_trivially_copyable_v<Local>,
                  "locals that may be written are compared byte by byte");
    static_assert(std::is_trivially_copyable_v<Result> && std::is_default_constructible_v<Result>,
                  "results are plain data: they are compared byte by byte");

    static_assert(((detail::Term<Terms>::need != detail::Need::excluded) && ...) &&
                      ((!detail::Term<Terms>::filters_rows && !detail::Term<Terms>::filters_chunks) && ...),
                  "terms are components, Optional or With");

public:
    Propagation() : changes_{required(), inputs()}, outputs_{outputs()} {}

    template <class Root, class Child>
    void operator()(World& world, const Root& root, const Child& child) {
        detail::AccessScope::check<Parent>(world, AccessKind::component, false);
        detail::AccessScope::check<Result>(world, AccessKind::component, true);
        check_access<Local>(world);
        (check_access<Terms>(world), ...);
        changes_.update(world);
        read_outside(world);
        if (changes_.any()) {
            find_tables(world);
            visit(root, child);
        }
        changes_.finish(world, info<Local>(), outputs_);
    }

    /// Memory held.
    [[nodiscard]] std::size_t memory_bytes() const {
        return changes_.memory_bytes() + tables_.capacity() * sizeof(Table) +
               outside_.capacity() * sizeof(Result);
    }

private:
    using Changes = detail::PropagationChanges;
    using Infos = std::vector<const ComponentInfo*>;
    static constexpr std::uint32_t k_none = Changes::k_none;
    /// Fewer segments are not worth waking other threads for.
    static constexpr std::size_t k_segments_in_parallel = 4;

    template <class... Handed>
    struct Extra {
        static_assert((std::is_pointer_v<typename detail::Term<Handed>::Cursor> && ...),
                      "terms are components in columns");
        std::tuple<typename detail::Term<Handed>::Cursor...> first_rows;

        Extra() = default;
        explicit Extra(const ArchetypeGraph& graph, const HierarchyNodes::Chunk& chunk)
            : first_rows{detail::Term<Handed>::cursor(
                  {graph, *chunk.archetype,
                   detail::column_in<typename detail::Term<Handed>::Part>(graph, *chunk.archetype),
                   chunk.index, 0})...} {}

        template <class F, class... Before>
        Result call(const F& f, std::uint32_t row, Before&&... before) const {
            return std::apply(
                [&](auto... column) {
                    return f(std::forward<Before>(before)..., detail::Term<Handed>::argument(column, row)...);
                },
                first_rows);
        }
    };
    using Extras = typename detail::HandedOut<Extra, std::tuple<>, Terms...>::Type;

    /// Where the 1024 slots of a chunk are.
    struct Table {
        Result* results;
        Local* locals;
        Extras extras;
    };

    template <class T>
    static void check_access(const World& world) {
        if constexpr (detail::Term<T>::handed_out) {
            detail::AccessScope::check<typename detail::Term<T>::Part>(world, AccessKind::component,
                                                                       detail::Term<T>::writes);
        }
    }
    template <class T>
    static const ComponentInfo* info() {
        return &component_info<typename detail::Term<T>::Part>();
    }
    static Infos required() {
        Infos infos{info<Local>(), info<Result>()};
        (void(detail::Term<Terms>::need == detail::Need::required ? infos.push_back(info<Terms>()) : void()),
         ...);
        return infos;
    }
    static Infos inputs() {
        Infos infos{info<Local>(), info<Parent>()};
        (void(detail::Term<Terms>::handed_out ? infos.push_back(info<Terms>()) : void()), ...);
        return infos;
    }
    static Infos outputs() {
        Infos infos{info<Result>()};
        (void(detail::Term<Terms>::writes ? infos.push_back(info<Terms>()) : void()), ...);
        return infos;
    }

    /// Takes a copy of what the parents outside have, so that all parents are found the same way.
    void read_outside(const World& world) {
        const HierarchyNodes& nodes = changes_.nodes();
        if (nodes.outside().empty()) return;
        std::size_t chunks = 0;
        outside_of_.resize(nodes.chunks().size());
        for (std::size_t c = 0; c < nodes.chunks().size(); ++c) {
            if (nodes.chunks()[c].archetype == nullptr) outside_of_[c] = chunks++ * k_chunk_rows;
        }
        outside_.resize(chunks * k_chunk_rows);
        for (const std::uint32_t node : nodes.outside()) {
            const std::uint32_t slot = nodes[node].slot;
            Result& known = outside_[outside_of_[slot / k_chunk_rows] + slot % k_chunk_rows];
            const Result* now = world.try_get<Result>(nodes[node].entity);
            changes_.note_outside(slot, now != nullptr, now != nullptr && !same(known, *now));
            if (now != nullptr) known = *now;
        }
    }

    void find_tables(World& world) {
        const ArchetypeGraph& graph = detail::WorldAccess::graph(world);
        const std::span<const HierarchyNodes::Chunk> chunks = changes_.nodes().chunks();
        tables_.resize(chunks.size());
        for (std::size_t c = 0; c < chunks.size(); ++c) {
            const HierarchyNodes::Chunk& chunk = chunks[c];
            if (chunk.archetype == nullptr) {
                tables_[c].results = outside_.empty() ? nullptr : outside_.data() + outside_of_[c];
            } else if (chunk.rows != 0) {
                tables_[c].results = column<Result>(graph, chunk);
                tables_[c].locals = column<Local>(graph, chunk);
                tables_[c].extras = Extras{graph, chunk};
            }
        }
    }

    /// First row of the chunk.
    template <class C>
    static C* column(const ArchetypeGraph& graph, const HierarchyNodes::Chunk& chunk) {
        const ColumnIndex index = detail::column_in<std::remove_const_t<C>>(graph, *chunk.archetype);
        return reinterpret_cast<C*>(chunk.archetype->columns()[index].base) +
               std::size_t{chunk.index} * k_chunk_rows;
    }

    template <class Root, class Child>
    void visit(const Root& root, const Child& child) {
        const HierarchyOrder& order = changes_.order();
        for (const HierarchyOrder::Entry entry : order.trunk())
            visit_changed(entry, root, child);
        const std::size_t segments = order.sequence().size();
        const auto visit_one = [&](std::size_t i) {
            visit_segment(order.segment(order.sequence()[i]), root, child);
        };
        if (segments < k_segments_in_parallel) {
            for (std::size_t i = 0; i < segments; ++i)
                visit_one(i);
        } else {
            detail::for_each_in_parallel(segments, visit_one);
        }
    }

    /// All of a segment but the trunk, which came before.
    template <class Root, class Child>
    void visit_segment(const HierarchyOrder::Segment& segment, const Root& root, const Child& child) {
        const Changes::Work work = changes_.work(segment);
        if (work == Changes::Work::none) return;
        const HierarchyOrder::Entry* const entries = segment.entries.data();
        std::size_t begin = 0;
        const auto visit_until = [&](std::size_t end) {
            if (work == Changes::Work::all) {
                for (std::size_t i = begin; i < end; ++i)
                    write(entries[i], root, child);
            } else {
                for (std::size_t i = begin; i < end; ++i)
                    visit_changed(entries[i], root, child);
            }
            begin = end + 1;
        };
        for (const std::uint32_t place : segment.trunk)
            visit_until(place);
        visit_until(segment.entries.size());
        if (work != Changes::Work::all) return;
        for (const std::uint32_t chunk : segment.chunks)
            changes_.wrote(chunk);
    }

    template <class Root, class Child>
    void visit_changed(HierarchyOrder::Entry entry, const Root& root, const Child& child) {
        const std::uint8_t above =
            entry.parent == k_none ? std::uint8_t{Changes::clean} : changes_.state(entry.parent);
        std::uint8_t& state = changes_.state(entry.slot);
        if ((above & Changes::resting) != 0) {
            state = Changes::resting;
        } else if (above != Changes::clean || changes_.is_dirty(entry.slot)) {
            const Result& result = result_of(entry.slot);
            const Result before = result;
            write(entry, root, child);
            state = static_cast<std::uint8_t>((above & Changes::forced) |
                                              (same(before, result) ? Changes::clean : Changes::changed));
            changes_.wrote(entry.slot / k_chunk_rows);
        } else {
            state = Changes::clean;
        }
    }

    template <class Root, class Child>
    void write(HierarchyOrder::Entry entry, const Root& root, const Child& child) {
        if constexpr (std::is_const_v<Local>) {
            result_of(entry.slot) = computed(entry, root, child);
        } else {
            const Local& local = tables_[entry.slot / k_chunk_rows].locals[entry.slot % k_chunk_rows];
            const Local before = local;
            result_of(entry.slot) = computed(entry, root, child);
            if (!same(before, local)) changes_.wrote_local(entry.slot / k_chunk_rows);
        }
    }

    template <class Root, class Child>
    Result computed(HierarchyOrder::Entry entry, const Root& root, const Child& child) const {
        const Table& table = tables_[entry.slot / k_chunk_rows];
        const std::uint32_t row = entry.slot % k_chunk_rows;
        if (entry.parent == k_none) return table.extras.call(root, row, table.locals[row]);
        return table.extras.call(child, row, std::as_const(result_of(entry.parent)), table.locals[row]);
    }

    [[nodiscard]] Result& result_of(std::uint32_t slot) const {
        return tables_[slot / k_chunk_rows].results[slot % k_chunk_rows];
    }

    template <class C>
    static bool same(const C& a, const C& b) {
        return std::memcmp(&a, &b, sizeof(C)) == 0;
    }

    Changes changes_;
    Infos outputs_;
    std::vector<Table> tables_;            ///< by chunk
    std::vector<Result> outside_;          ///< of the slots outside
    std::vector<std::size_t> outside_of_;  ///< by chunk: where its slots begin in outside_
};

}  // namespace rambla::ecs
