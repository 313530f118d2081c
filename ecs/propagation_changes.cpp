#include "ecs/propagation_changes.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "ecs/access_scope.h"
#include "ecs/world_access.h"

namespace rambla::ecs::detail {
namespace {

constexpr std::uint8_t k_some_to_do = 1;
constexpr std::uint8_t k_not_all = 2;

}  // namespace

void PropagationChanges::update(World& world) {
    try {
        if (nodes_.update(world, since_)) order_.update(nodes_);
    } catch (...) {  // an order that is half made anew is made from nothing the next time
        nodes_.forget();
        throw;
    }
    if (nodes_.changes().anew) {  // what was known of slots was of other rows
        chunks_.clear();
        written_.clear();
        states_.clear();
        unfinished_ = true;
    }
    const std::span<const HierarchyNodes::Chunk> chunks = nodes_.chunks();
    chunks_.resize(chunks.size());
    written_.resize(chunks.size());
    states_.resize(chunks.size() * k_chunk_rows);
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const bool all = std::exchange(unfinished_, true);
    any_ = false;
    for (std::size_t c = 0; c < chunks.size(); ++c) {
        if (chunks[c].archetype == nullptr) {
            chunks_[c] = 0;
        } else {
            const bool again = std::exchange(written_[c], std::uint8_t{0}) != 0;
            const bool dirty = chunks[c].rows != 0 && (all || again || inputs_written(graph, chunks[c]));
            chunks_[c] = dirty ? k_some_to_do : k_not_all;
            any_ |= dirty;
        }
    }
    if (nodes_.changes_found()) {
        for (const std::uint32_t slot : order_.fresh()) {
            chunks_[slot / k_chunk_rows] = k_some_to_do;
            any_ = true;
        }
    }
}

bool PropagationChanges::inputs_written(const ArchetypeGraph& graph,
                                        const HierarchyNodes::Chunk& chunk) const {
    const Archetype& archetype = *chunk.archetype;
    if (is_since(archetype.rows_version(chunk.index), since_)) return true;
    return std::ranges::any_of(inputs_, [&](const ComponentInfo* input) {
        const ColumnIndex column = archetype.column_of(graph.find_component(input->type_index));
        return column < k_tag_column && is_since(archetype.version(column, chunk.index), since_);
    });
}

void PropagationChanges::note_outside(std::uint32_t slot, bool has_result, bool differs) {
    std::uint8_t& state = states_[slot];
    std::uint8_t& chunk = chunks_[slot / k_chunk_rows];
    if (!has_result) {
        state = resting;
        chunk |= k_not_all;
        return;
    }
    const bool returns = (state & resting) != 0;
    state = static_cast<std::uint8_t>(returns ? changed | forced : differs ? changed : clean);
    if (state == clean) return;
    chunk |= k_some_to_do | k_not_all;
    any_ = true;
}

PropagationChanges::Work PropagationChanges::work(const HierarchyOrder::Segment& segment) const {
    std::uint8_t found = 0;
    for (const std::uint32_t chunk : segment.chunks)
        found |= chunks_[chunk];
    const std::uint32_t parent = segment.entries.front().parent;
    if (parent != k_none) {  // what changes or rests above the segment does so for its first member as well
        const std::uint8_t above = states_[parent];
        if ((above & (changed | forced)) != 0) found |= k_some_to_do | k_not_all;
        if ((above & resting) != 0) found |= k_not_all;
    }
    if ((found & k_some_to_do) == 0) return Work::none;
    return (found & k_not_all) == 0 ? Work::all : Work::some;
}

void PropagationChanges::note(std::uint32_t chunk, std::uint8_t what) {
    std::atomic_ref<std::uint8_t> flags{written_[chunk]};
    if ((flags.load(std::memory_order_relaxed) & what) != what)
        flags.fetch_or(what, std::memory_order_relaxed);
}

void PropagationChanges::finish(World& world, const ComponentInfo* local,
                                std::span<const ComponentInfo* const> outputs) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const auto stamp = [&](const HierarchyNodes::Chunk& chunk, const ComponentInfo* component) {
        const ColumnIndex column = chunk.archetype->column_of(graph.find_component(component->type_index));
        if (column < k_tag_column) chunk.archetype->stamp(column, chunk.index, world.version());
    };
    for (std::size_t c = 0; any_ && c < written_.size(); ++c) {
        if (written_[c] == 0) continue;
        const HierarchyNodes::Chunk& chunk = nodes_.chunks()[c];
        if (chunk.archetype == nullptr) {  // parents outside, of a segment that was written as a whole
            written_[c] = 0;
            continue;
        }
        if ((written_[c] & k_wrote_local) != 0) stamp(chunk, local);
        for (const ComponentInfo* output : outputs)
            stamp(chunk, output);
        written_[c] &= k_wrote_local;
    }
    unfinished_ = false;
    if (!AccessScope::shares(world)) world.advance_version();
    since_ = world.version();
}

std::size_t PropagationChanges::memory_bytes() const {
    return nodes_.memory_bytes() + order_.memory_bytes() + chunks_.capacity() + states_.capacity() +
           written_.capacity();
}

}  // namespace rambla::ecs::detail
