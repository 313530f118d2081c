#include "ecs/hierarchy_nodes.h"

#include <algorithm>

#include "ecs/world_access.h"

namespace rambla::ecs {
namespace {

std::uint32_t chunks_of(const Archetype& archetype) {
    return (archetype.rows() + k_chunk_rows - 1) / k_chunk_rows;
}

}  // namespace

bool HierarchyNodes::update(World& world, std::uint32_t since) {
    world_ = &world;
    try {
        follow(since);
    } catch (...) {  // links half made help nobody, and who was found lost must be found again
        forget();
        throw;
    }
    return changes_found();
}

void HierarchyNodes::follow(std::uint32_t since) {
    clear_changes();
    const std::uint64_t serial = detail::WorldAccess::serial(*world_);
    if (serial != world_serial_) {
        forget();
        changes_.anew = true;
        world_serial_ = serial;
    }
    match_archetypes();
    find_changed_chunks(since, changes_.anew);
    if (!outside_.empty() && rows_changed_anywhere(since)) release_dead_outsiders();
    // All rows that went are forgotten before any that came is read: rows move between chunks.
    for (const auto& [chunk, column] : changed_chunks_)
        forget_moved_rows(chunk);
    for (const auto& [chunk, column] : changed_chunks_)
        read_rows(chunk, column);
    settle_homeless();
}

std::uint32_t HierarchyNodes::find(Entity entity) const {
    if (entity.index >= node_of_.size()) return k_none;
    const std::uint32_t node = node_of_[entity.index];
    return node != k_none && nodes_[node].entity == entity ? node : k_none;
}

std::size_t HierarchyNodes::memory_bytes() const {
    const auto bytes_of = [](const auto& vector) {
        return vector.capacity() * sizeof(vector[0]);
    };
    std::size_t bytes = bytes_of(matches_) + bytes_of(chunks_) + bytes_of(node_at_) + bytes_of(nodes_) +
                        bytes_of(node_of_) + bytes_of(free_nodes_) + bytes_of(outside_) +
                        bytes_of(free_outside_slots_) + bytes_of(homeless_) + bytes_of(changed_chunks_) +
                        bytes_of(changes_.relinked) + bytes_of(changes_.moved) + bytes_of(changes_.segments);
    for (const Match& match : matches_)
        bytes += bytes_of(match.chunks);
    return bytes;
}

void HierarchyNodes::clear_changes() noexcept {
    changes_.anew = false;
    changes_.relinked.clear();
    changes_.moved.clear();
    changes_.segments.clear();
}

void HierarchyNodes::forget() noexcept {
    world_serial_ = 0;
    archetypes_seen_ = 0;
    matches_.clear();
    chunks_.clear();
    node_at_.clear();
    nodes_.clear();
    node_of_.clear();
    free_nodes_.clear();
    outside_.clear();
    free_outside_slots_.clear();
    homeless_.clear();
    clear_changes();
}

void HierarchyNodes::match_archetypes() {
    ArchetypeGraph& graph = detail::WorldAccess::graph(*world_);
    for (; archetypes_seen_ < graph.size(); ++archetypes_seen_) {
        Archetype& archetype = graph[archetypes_seen_];
        const bool fits = std::ranges::all_of(required_, [&](const ComponentInfo* info) {
            return archetype.has(graph.find_component(info->type_index));
        });
        const ColumnIndex parent = archetype.column_of(graph.find_component(type_index<Parent>()));
        if (fits) matches_.push_back({&archetype, parent, {}});
    }
}

void HierarchyNodes::find_changed_chunks(std::uint32_t since, bool all) {
    changed_chunks_.clear();
    for (Match& match : matches_) {
        const std::uint32_t now = chunks_of(*match.archetype);
        while (match.chunks.size() < now) {
            match.chunks.push_back(
                new_chunk(match.archetype, static_cast<std::uint32_t>(match.chunks.size())));
        }
        for (std::uint32_t c = 0; c < match.chunks.size(); ++c) {
            const bool gone = c >= now;
            const bool changed =
                gone ? chunks_[match.chunks[c]].rows != 0 : all || is_since(links_version(match, c), since);
            if (changed) changed_chunks_.emplace_back(match.chunks[c], match.parent);
        }
    }
}

/// When rows of a chunk came or went, or their parents were written.
std::uint32_t HierarchyNodes::links_version(const Match& match, std::uint32_t chunk) {
    return match.parent == k_no_column ? match.archetype->rows_version(chunk)
                                       : match.archetype->version(match.parent, chunk);
}

bool HierarchyNodes::rows_changed_anywhere(std::uint32_t since) const {
    const ArchetypeGraph& graph = detail::WorldAccess::graph(*world_);
    for (std::size_t a = 0; a < graph.size(); ++a) {
        if (is_since(graph[a].rows_version(), since)) return true;
    }
    return false;
}

void HierarchyNodes::release_dead_outsiders() {
    for (std::size_t i = outside_.size(); i-- > 0;) {
        if (!world_->alive(nodes_[outside_[i]].entity)) release(outside_[i]);
    }
}

void HierarchyNodes::forget_moved_rows(std::uint32_t chunk) {
    Chunk& seen = chunks_[chunk];
    const std::uint32_t first = seen.index * k_chunk_rows;
    const std::uint32_t rows = seen.archetype->rows();
    const Entity* entities = seen.archetype->entities();
    for (std::uint32_t i = 0; i < seen.rows; ++i) {
        std::uint32_t& node = node_at_[chunk * k_chunk_rows + i];
        if (first + i < rows && nodes_[node].entity == entities[first + i]) continue;
        nodes_[node].slot = k_none;
        homeless_.push_back(node);
        node = k_none;
    }
    seen.rows = rows > first ? std::min(rows - first, k_chunk_rows) : 0;
}

void HierarchyNodes::read_rows(std::uint32_t chunk, ColumnIndex parent_column) {
    const Archetype& archetype = *chunks_[chunk].archetype;
    const std::uint32_t first = chunks_[chunk].index * k_chunk_rows;
    const Parent* parents = parent_column == k_no_column
                                ? nullptr
                                : reinterpret_cast<const Parent*>(archetype.columns()[parent_column].base);
    for (std::uint32_t i = 0; i < chunks_[chunk].rows; ++i) {
        const std::uint32_t slot = chunk * k_chunk_rows + i;
        const Entity parent = parents == nullptr ? Entity{} : parents[first + i].entity;
        std::uint32_t node = node_at_[slot];
        if (node == k_none) {
            node = node_for(archetype.entities()[first + i]);
            const bool member = nodes_[node].kind > Kind::outside;
            enter(node, slot);
            if (!member || nodes_[node].parent != parent) {
                relink(node, parent);
            } else {
                changes_.moved.push_back(node);
            }
        } else if (nodes_[node].parent != parent) {
            relink(node, parent);
        }
    }
}

void HierarchyNodes::settle_homeless() {
    for (const std::uint32_t node : homeless_) {
        if (nodes_[node].kind > Kind::outside && nodes_[node].slot == k_none) leave(node);
    }
    homeless_.clear();
}

/// Gives a node its row.
void HierarchyNodes::enter(std::uint32_t node, std::uint32_t slot) {
    if (nodes_[node].kind == Kind::outside) come_inside(node);
    nodes_[node].slot = slot;
    node_at_[slot] = node;
}

/// Ends the membership of a node without a row.
void HierarchyNodes::leave(std::uint32_t node) {
    if (!world_->alive(nodes_[node].entity) || nodes_[node].first == k_none) {
        release(node);
        return;
    }
    unlink(node);
    if (nodes_[node].segment != k_none) changes_.segments.push_back(nodes_[node].segment);
    nodes_[node].segment = k_none;
    nodes_[node].parent = {};
    go_outside(node);
    announce_children(node);
}

void HierarchyNodes::relink(std::uint32_t node, Entity parent) {
    unlink(node);
    changes_.relinked.push_back(node);
    nodes_[node].parent = parent;
    if (parent == Entity{}) {
        nodes_[node].kind = Kind::root;
    } else if (parent == nodes_[node].entity || !world_->alive(parent)) {
        nodes_[node].kind = Kind::lost;
    } else {
        nodes_[node].kind = Kind::child;
        std::uint32_t up = node_for(parent);
        if (nodes_[up].kind == Kind::unused) go_outside(up);
        link(node, up);
    }
}

void HierarchyNodes::link(std::uint32_t node, std::uint32_t up) {
    Node& child = nodes_[node];
    child.up = up;
    child.next = k_none;
    const std::uint32_t first = nodes_[up].first;
    if (first == k_none) {
        nodes_[up].first = child.previous = node;
        return;
    }
    child.previous = nodes_[first].previous;
    nodes_[child.previous].next = node;
    nodes_[first].previous = node;
}

/// Takes a node off its parent's children; an outsider without children is of no use any more.
void HierarchyNodes::unlink(std::uint32_t node) {
    Node& child = nodes_[node];
    if (child.up == k_none) return;
    const std::uint32_t up = child.up;
    const std::uint32_t first = nodes_[up].first;
    if (first == node) {
        nodes_[up].first = child.next;
    } else {
        nodes_[child.previous].next = child.next;
    }
    if (child.next != k_none) {
        nodes_[child.next].previous = child.previous;
    } else if (first != node) {
        nodes_[first].previous = child.previous;
    }
    child.up = child.next = child.previous = k_none;
    if (nodes_[up].kind == Kind::outside && nodes_[up].first == k_none) release(up);
}

void HierarchyNodes::abandon_children(std::uint32_t node) {
    for (std::uint32_t child = nodes_[node].first; child != k_none;) {
        const std::uint32_t next = nodes_[child].next;
        nodes_[child].up = nodes_[child].next = nodes_[child].previous = k_none;
        nodes_[child].kind = Kind::lost;
        changes_.relinked.push_back(child);
        child = next;
    }
    nodes_[node].first = k_none;
}

void HierarchyNodes::announce_children(std::uint32_t node) {
    for (std::uint32_t child = nodes_[node].first; child != k_none; child = nodes_[child].next)
        changes_.relinked.push_back(child);
}

std::uint32_t HierarchyNodes::make(Entity entity) {
    std::uint32_t node = static_cast<std::uint32_t>(nodes_.size());
    if (free_nodes_.empty()) {
        nodes_.emplace_back();
    } else {
        node = free_nodes_.back();
        free_nodes_.pop_back();
        nodes_[node] = {};
    }
    nodes_[node].entity = entity;
    if (node_of_.size() <= entity.index) node_of_.resize(entity.index + std::size_t{1}, k_none);
    node_of_[entity.index] = node;
    return node;
}

/// The node of a living entity, made if need be: then its kind is still unused.
std::uint32_t HierarchyNodes::node_for(Entity entity) {
    if (entity.index < node_of_.size() && node_of_[entity.index] != k_none) {
        const std::uint32_t known = node_of_[entity.index];
        if (nodes_[known].entity == entity) return known;
        release(known);  // of an earlier generation, so it is dead
    }
    return make(entity);
}

void HierarchyNodes::go_outside(std::uint32_t node) {
    nodes_[node].kind = Kind::outside;
    nodes_[node].place = static_cast<std::uint32_t>(outside_.size());
    outside_.push_back(node);
    if (free_outside_slots_.empty()) {
        const std::uint32_t chunk = new_chunk(nullptr, 0);
        for (std::uint32_t i = k_chunk_rows; i-- > 0;)
            free_outside_slots_.push_back(chunk * k_chunk_rows + i);
    }
    nodes_[node].slot = free_outside_slots_.back();
    free_outside_slots_.pop_back();
}

void HierarchyNodes::come_inside(std::uint32_t node) {
    const std::uint32_t place = nodes_[node].place;
    nodes_[outside_.back()].place = place;
    outside_[place] = outside_.back();
    outside_.pop_back();
    free_outside_slots_.push_back(nodes_[node].slot);
    nodes_[node].slot = k_none;
    nodes_[node].kind = Kind::unused;
    announce_children(node);
}

void HierarchyNodes::release(std::uint32_t node) {
    if (nodes_[node].kind == Kind::outside) come_inside(node);
    unlink(node);
    abandon_children(node);
    if (nodes_[node].segment != k_none) changes_.segments.push_back(nodes_[node].segment);
    node_of_[nodes_[node].entity.index] = k_none;
    nodes_[node] = {};
    free_nodes_.push_back(node);
}

std::uint32_t HierarchyNodes::new_chunk(Archetype* archetype, std::uint32_t index) {
    chunks_.push_back({archetype, index, 0});
    node_at_.resize(chunks_.size() * k_chunk_rows, k_none);
    return static_cast<std::uint32_t>(chunks_.size() - 1);
}

}  // namespace rambla::ecs
