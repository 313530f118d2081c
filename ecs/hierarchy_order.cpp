#include "ecs/hierarchy_order.h"

#include <algorithm>
#include <utility>

namespace rambla::ecs {
namespace {

/// Segment of members that wait in `pending_`.
constexpr std::uint32_t k_pending = 0xfffffffeu;

/// Smaller segments are joined with the next one when either is made anew.
constexpr std::size_t k_smallest_segment = HierarchyOrder::k_segment / 4;

}  // namespace

void HierarchyOrder::update(HierarchyNodes& nodes) {
    if (nodes.changes().anew) *this = {};
    fresh_.clear();
    take_out_changed(nodes);
    find_new_places(nodes);
    rebuild_stale(nodes);
    find_trunk(nodes);
}

std::size_t HierarchyOrder::memory_bytes() const {
    const auto bytes_of = [](const auto& vector) {
        return vector.capacity() * sizeof(vector[0]);
    };
    std::size_t bytes = bytes_of(segments_) + bytes_of(sequence_) + bytes_of(next_sequence_) +
                        bytes_of(free_segments_) + bytes_of(trunk_) + bytes_of(trunk_entries_) +
                        bytes_of(fresh_) + bytes_of(new_tops_) + bytes_of(pending_) + bytes_of(stack_) +
                        bytes_of(last_segment_of_);
    for (const Segment& segment : segments_) {
        bytes += bytes_of(segment.entries) + bytes_of(segment.nodes) + bytes_of(segment.chunks) +
                 bytes_of(segment.trunk);
    }
    return bytes;
}

void HierarchyOrder::take_out_changed(HierarchyNodes& nodes) {
    const HierarchyNodes::Changes& changes = nodes.changes();
    for (const std::uint32_t segment : changes.segments)
        mark(segment);
    for (const std::uint32_t node : changes.relinked)
        take_out_subtree(nodes, node);
    for (const std::uint32_t node : changes.moved) {
        mark(nodes[node].segment);
        for (std::uint32_t child = nodes[node].first; child != k_none; child = nodes[child].next)
            mark(nodes[child].segment);
    }
}

/// What hangs from a member that is not in the order is not in the order either, so that the walk may stop
/// there; this also ends it in a ring.
void HierarchyOrder::take_out_subtree(HierarchyNodes& nodes, std::uint32_t top) {
    if (nodes[top].segment == k_none || nodes[top].kind <= HierarchyNodes::Kind::outside) return;
    stack_.assign(1, top);
    mark(std::exchange(nodes[top].segment, k_none));
    while (!stack_.empty()) {
        const std::uint32_t node = stack_.back();
        stack_.pop_back();
        for (std::uint32_t child = nodes[node].first; child != k_none; child = nodes[child].next) {
            if (nodes[child].segment == k_none) continue;
            mark(std::exchange(nodes[child].segment, k_none));
            stack_.push_back(child);
        }
    }
}

void HierarchyOrder::find_new_places(HierarchyNodes& nodes) {
    new_tops_.clear();
    for (const std::uint32_t node : nodes.changes().relinked) {
        const HierarchyNodes::Node& changed = nodes[node];
        if (changed.kind <= HierarchyNodes::Kind::outside || changed.kind == HierarchyNodes::Kind::lost)
            continue;
        if (nodes.hangs(node)) {
            mark(nodes[changed.up].segment);
        } else {
            new_tops_.push_back(node);
        }
    }
}

void HierarchyOrder::rebuild_stale(HierarchyNodes& nodes) {
    next_sequence_.clear();
    pending_.clear();
    for (const std::uint32_t number : sequence_) {
        const bool small = segments_[number].nodes.size() < k_smallest_segment;
        const bool joins = !pending_.empty() && (pending_.size() < k_smallest_segment || small);
        if (segments_[number].stale || joins) {
            emit_segment(nodes, number);
            segments_[number].stale = false;
            free_segments_.push_back(number);
        } else {
            cut(nodes);
            next_sequence_.push_back(number);
        }
    }
    for (const std::uint32_t node : new_tops_) {
        if (nodes[node].segment == k_none) emit_subtree(nodes, node);
    }
    cut(nodes);
    sequence_.swap(next_sequence_);
}

/// What is still in the segment, with what now hangs from it and was not in the order.
void HierarchyOrder::emit_segment(HierarchyNodes& nodes, std::uint32_t segment) {
    const std::vector<std::uint32_t>& members = segments_[segment].nodes;
    for (std::uint32_t i = 0; i < members.size(); ++i) {
        HierarchyNodes::Node& node = nodes[members[i]];
        if (node.segment != segment || node.place != i) continue;
        node.segment = k_pending;
        pending_.push_back(members[i]);
        emit_new_children(nodes, members[i]);
    }
}

/// New children are linked behind those that are in the order.
void HierarchyOrder::emit_new_children(HierarchyNodes& nodes, std::uint32_t node) {
    const std::uint32_t first = nodes[node].first;
    if (first == k_none) return;
    std::uint32_t child = nodes[first].previous;
    if (nodes[child].segment != k_none) return;
    while (child != first && nodes[nodes[child].previous].segment == k_none)
        child = nodes[child].previous;
    for (; child != k_none; child = nodes[child].next)
        emit_subtree(nodes, child);
}

void HierarchyOrder::emit_subtree(HierarchyNodes& nodes, std::uint32_t top) {
    std::uint32_t node = top;
    while (true) {
        nodes[node].segment = k_pending;
        pending_.push_back(node);
        fresh_.push_back(nodes[node].slot);
        if (nodes[node].first != k_none) {
            node = nodes[node].first;
            continue;
        }
        while (node != top && nodes[node].next == k_none)
            node = nodes[node].up;
        if (node == top) return;
        node = nodes[node].next;
    }
}

/// Puts the pending members into segments of equal size.
void HierarchyOrder::cut(HierarchyNodes& nodes) {
    const std::size_t count = (pending_.size() + k_segment - 1) / k_segment;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = pending_.size() * i / count;
        const std::size_t end = pending_.size() * (i + 1) / count;
        const std::uint32_t segment = new_segment();
        fill(nodes, segment, std::span{pending_}.subspan(begin, end - begin));
        next_sequence_.push_back(segment);
    }
    pending_.clear();
}

void HierarchyOrder::fill(HierarchyNodes& nodes, std::uint32_t number,
                          std::span<const std::uint32_t> members) {
    Segment& segment = segments_[number];
    segment.nodes.assign(members.begin(), members.end());
    segment.entries.clear();
    segment.chunks.clear();
    last_segment_of_.resize(nodes.chunks().size(), k_none);
    const auto note_chunk = [&](std::uint32_t slot) {
        const std::uint32_t chunk = slot / k_chunk_rows;
        if (std::exchange(last_segment_of_[chunk], number) != number) segment.chunks.push_back(chunk);
    };
    for (std::uint32_t i = 0; i < members.size(); ++i) {
        HierarchyNodes::Node& node = nodes[members[i]];
        node.segment = number;
        node.place = i;
        note_chunk(node.slot);
        const bool top = !nodes.hangs(members[i]);
        const std::uint32_t parent = node.up == k_none ? k_none : nodes[node.up].slot;
        if (top && parent != k_none) note_chunk(parent);
        segment.entries.push_back({node.slot, parent});
    }
    for (const std::uint32_t chunk : segment.chunks)
        last_segment_of_[chunk] = k_none;
}

/// Ancestors of a segment's first member that an earlier segment does not share come later in the order than
/// those that were found before, so that places come out ascending.
void HierarchyOrder::find_trunk(HierarchyNodes& nodes) {
    for (const std::uint32_t node : trunk_)
        nodes[node].trunk = false;
    trunk_.clear();
    trunk_entries_.clear();
    for (const std::uint32_t number : sequence_)
        segments_[number].trunk.clear();
    for (const std::uint32_t number : sequence_) {
        const std::size_t before = trunk_.size();
        std::uint32_t node = segments_[number].nodes.front();
        while (nodes.hangs(node) && !nodes[nodes[node].up].trunk) {
            node = nodes[node].up;
            nodes[node].trunk = true;
            trunk_.push_back(node);
        }
        std::reverse(trunk_.begin() + static_cast<std::ptrdiff_t>(before), trunk_.end());
        for (std::size_t i = before; i < trunk_.size(); ++i) {
            Segment& segment = segments_[nodes[trunk_[i]].segment];
            segment.trunk.push_back(nodes[trunk_[i]].place);
            trunk_entries_.push_back(segment.entries[nodes[trunk_[i]].place]);
        }
    }
}

std::uint32_t HierarchyOrder::new_segment() {
    if (free_segments_.empty()) {
        segments_.emplace_back();
        return static_cast<std::uint32_t>(segments_.size() - 1);
    }
    const std::uint32_t number = free_segments_.back();
    free_segments_.pop_back();
    return number;
}

}  // namespace rambla::ecs
