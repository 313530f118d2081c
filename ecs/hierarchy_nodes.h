#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecs/archetype.h"
#include "ecs/parent.h"
#include "ecs/world.h"

namespace rambla::ecs {

/// The trees that Parent components describe, as links between nodes, for the entities that have certain
/// components (the members). Living parents that are no members get a node of their own, outside.
///
/// update() reads only the rows of chunks whose version says that rows came or went or that a Parent was
/// written, and tells what it found changed. Nothing here recurses: depth and width are bounded by memory.
class HierarchyNodes {
public:
    static constexpr std::uint32_t k_none = 0xffffffffu;

    enum class Kind : std::uint8_t {
        unused,
        outside,  ///< a living parent, itself no member
        root,     ///< a member without parent
        child,    ///< a member whose parent has a node
        lost,     ///< a member whose parent is dead or itself
    };

    /// `slot` is where the row is: number of the chunk (see chunks()) × 1024 + place.
    struct Node {
        Entity entity;
        Entity parent;  ///< as the component says; null without one
        std::uint32_t slot = k_none;
        std::uint32_t up = k_none;
        std::uint32_t first = k_none;  ///< child linked first; its `previous` is the last one
        std::uint32_t next = k_none;
        std::uint32_t previous = k_none;
        std::uint32_t segment = k_none;  ///< kept by HierarchyOrder, with `place`
        std::uint32_t place = 0;
        Kind kind = Kind::unused;
        bool trunk = false;  ///< kept by HierarchyOrder
    };

    /// 1024 slots: the rows of a chunk, or nodes outside.
    struct Chunk {
        Archetype* archetype = nullptr;  ///< null: outside
        std::uint32_t index = 0;         ///< of the chunk in its archetype
        std::uint32_t rows = 0;          ///< seen by the last update
    };

    /// What the last update() found.
    struct Changes {
        bool anew =
            false;  ///< nodes known before are forgotten: those that there are now are all in `relinked`
        std::vector<std::uint32_t> relinked;  ///< nodes that are new or hang from another one now
        std::vector<std::uint32_t> moved;     ///< nodes whose slot changed
        std::vector<std::uint32_t> segments;  ///< `segment` of nodes that are gone
    };

    /// @param required  components of the members
    explicit HierarchyNodes(std::vector<const ComponentInfo*> required) : required_{std::move(required)} {}

    /// Follows the world. Returns whether anything changed. Looks at two versions per chunk, then only at
    /// changed chunks; allocates nothing when there are none. Reads all of a world that is another one than
    /// before. After an exception nothing is known, and the next call reads everything.
    /// @param since  version from which on writes may not have been seen
    bool update(World& world, std::uint32_t since);
    /// Forgets everything: the next update() reads the whole world, and finds who is lost again. For users
    /// that could not take in what update() found.
    void forget() noexcept;

    [[nodiscard]] std::span<const Chunk> chunks() const { return chunks_; }
    [[nodiscard]] Node& operator[](std::uint32_t node) { return nodes_[node]; }
    [[nodiscard]] const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
    /// The node of an entity, k_none if it has none.
    [[nodiscard]] std::uint32_t find(Entity entity) const;
    [[nodiscard]] std::span<const std::uint32_t> outside() const { return outside_; }
    [[nodiscard]] const Changes& changes() const { return changes_; }
    [[nodiscard]] bool changes_found() const {
        return changes_.anew || !changes_.relinked.empty() || !changes_.moved.empty() ||
               !changes_.segments.empty();
    }
    /// Whether a node hangs from a member.
    [[nodiscard]] bool hangs(std::uint32_t node) const {
        return nodes_[node].up != k_none && nodes_[nodes_[node].up].kind != Kind::outside;
    }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct Match {
        Archetype* archetype;
        ColumnIndex parent;                 ///< k_no_column: all are roots
        std::vector<std::uint32_t> chunks;  ///< numbers
    };

    void follow(std::uint32_t since);
    void clear_changes() noexcept;
    void match_archetypes();
    void find_changed_chunks(std::uint32_t since, bool all);
    [[nodiscard]] static std::uint32_t links_version(const Match& match, std::uint32_t chunk);
    [[nodiscard]] bool rows_changed_anywhere(std::uint32_t since) const;
    void release_dead_outsiders();
    void forget_moved_rows(std::uint32_t chunk);
    void read_rows(std::uint32_t chunk, ColumnIndex parent_column);
    void settle_homeless();

    void enter(std::uint32_t node, std::uint32_t slot);
    void leave(std::uint32_t node);
    void relink(std::uint32_t node, Entity parent);
    void link(std::uint32_t node, std::uint32_t up);
    void unlink(std::uint32_t node);
    void abandon_children(std::uint32_t node);
    void announce_children(std::uint32_t node);
    [[nodiscard]] std::uint32_t make(Entity entity);
    [[nodiscard]] std::uint32_t node_for(Entity entity);
    void go_outside(std::uint32_t node);
    void come_inside(std::uint32_t node);
    void release(std::uint32_t node);
    [[nodiscard]] std::uint32_t new_chunk(Archetype* archetype, std::uint32_t index);

    World* world_ = nullptr;  ///< during update()
    std::vector<const ComponentInfo*> required_;
    std::uint64_t world_serial_ = 0;  ///< 0: nothing is known
    std::size_t archetypes_seen_ = 0;
    std::vector<Match> matches_;
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> node_at_;  ///< by slot
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> node_of_;  ///< by entity index
    std::vector<std::uint32_t> free_nodes_;
    std::vector<std::uint32_t> outside_;
    std::vector<std::uint32_t> free_outside_slots_;
    std::vector<std::uint32_t> homeless_;  ///< members whose row went away in this update
    std::vector<std::pair<std::uint32_t, ColumnIndex>> changed_chunks_;
    Changes changes_;
};

}  // namespace rambla::ecs
