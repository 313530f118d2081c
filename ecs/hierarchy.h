#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "ecs/commands.h"
#include "ecs/hierarchy_nodes.h"
#include "ecs/observers.h"
#include "ecs/parent.h"
#include "ecs/world.h"

namespace rambla::ecs {

/// The parents of an entity, the nearest first, as the Parent components say now. Ends at an entity without
/// parent or with a dead one. Throws Misuse where the parents form a ring.
class Ancestors {
public:
    Ancestors(const World& world, Entity entity) : world_{&world}, entity_{entity} {}

    class Iterator {
    public:
        using value_type = Entity;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::input_iterator_tag;

        Iterator(const World& world, Entity entity) : world_{&world}, now_{entity}, mark_{entity} { ++*this; }
        Entity operator*() const { return now_; }
        Iterator& operator++();
        void operator++(int) { ++*this; }
        bool operator==(std::default_sentinel_t) const { return now_ == Entity{}; }

    private:
        const World* world_;
        Entity now_;
        Entity mark_;  ///< met before: whoever meets it again runs in a ring
        std::size_t steps_ = 0;
        std::size_t next_mark_ = 1;
    };
    /// The nearest. Throws as the steps do.
    [[nodiscard]] Iterator begin() const { return {*world_, entity_}; }
    /// Above the root.
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }

private:
    const World* world_;
    Entity entity_;
};

/// The trees of a world's Parent components, from above: who the children of an entity are, and what happens
/// to them when it ends.
class Hierarchy {
public:
    /// @param world  must outlive it
    explicit Hierarchy(World& world) : world_{world} {}
    ~Hierarchy();
    Hierarchy(const Hierarchy&) = delete;
    Hierarchy& operator=(const Hierarchy&) = delete;

    /// The children of an entity as of the last update(), in the order in which updates met them. Valid until
    /// the next update().
    class Children {
    public:
        class Iterator {
        public:
            using value_type = Entity;
            using difference_type = std::ptrdiff_t;

            Iterator() = default;
            Iterator(const HierarchyNodes& nodes, std::uint32_t node) : nodes_{&nodes}, node_{node} {}
            Entity operator*() const { return (*nodes_)[node_].entity; }
            Iterator& operator++() {
                node_ = (*nodes_)[node_].next;
                return *this;
            }
            Iterator operator++(int) {
                Iterator before = *this;
                ++*this;
                return before;
            }
            bool operator==(const Iterator& other) const { return node_ == other.node_; }

        private:
            const HierarchyNodes* nodes_ = nullptr;
            std::uint32_t node_ = HierarchyNodes::k_none;
        };
        Children(const HierarchyNodes& nodes, std::uint32_t first) : nodes_{&nodes}, first_{first} {}
        /// The child met first.
        [[nodiscard]] Iterator begin() const { return {*nodes_, first_}; }
        /// Behind the last child.
        [[nodiscard]] Iterator end() const { return {*nodes_, HierarchyNodes::k_none}; }
        /// Whether there are none.
        [[nodiscard]] bool empty() const { return first_ == HierarchyNodes::k_none; }

    private:
        const HierarchyNodes* nodes_;
        std::uint32_t first_;
    };

    /// Follows the Parent components: looks at the version of each chunk that has them, and reads the chunks
    /// that changed. Ends the world's version. Allocates nothing when nothing changed.
    void update();

    /// The children of an entity, see Children; none for entities that are no parents, or not alive.
    [[nodiscard]] Children children(Entity entity) const;
    /// See Ancestors.
    [[nodiscard]] Ancestors ancestors(Entity entity) const { return {world_, entity}; }
    /// Number of ancestors: 0 for roots.
    [[nodiscard]] std::size_t depth(Entity entity) const;

    /// Hangs the child below the parent, with all its own children; below the null entity: makes it a root.
    /// Throws Misuse on a stale handle, and when the parent hangs from the child.
    void set_parent(Entity child, Entity parent, OnParentEnd on_end = OnParentEnd::destroyed);

    /// Ends an entity, and destroys or frees what hangs from it as the Parent components say. Throws Misuse
    /// on a stale handle, and where World::destroy does. Returns how many entities ended.
    std::size_t destroy(Entity entity);
    /// Does the same for entities whose parent has ended by other ways. Returns how many ended. Throws
    /// Misuse where World::destroy does.
    std::size_t end_orphans();
    /// Plays commands, then ends the orphans that they left.
    Playback apply(Commands& commands);

    /// From now on, as long as this lives, orphans end by themselves, whatever way their parent ended:
    /// World::destroy, Commands, commands for all entities, a schedule. When a change (one call, or one
    /// playback as a whole) has ended entities, what hangs from them, however deep, is destroyed or freed by
    /// one more playback, together with what observers recorded, before the call returns. What counts are the
    /// Parent components as that change left them; those that name an entity that ended earlier count with
    /// the next change that ends one. So they do after an exception: when memory runs out, the entity that
    /// was to end has ended, and the next end, or end_orphans(), ends what hangs from it.
    ///
    /// Worlds where this is never called pay nothing. Others pay for every change that ends entities what
    /// update() costs, so end many by Commands, not one by one; and what worlds with observers do. Throws
    /// Misuse when called twice, and as World::observers().
    void follow_ends();

    /// Memory held.
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    friend class Observers;

    /// Records the end of all orphans, for an observer's playback.
    void record_orphans(Commands& commands);
    void note_lost();
    [[nodiscard]] bool is_orphan(Entity entity) const;
    void collect_orphans();
    void begin_collecting();
    void collect(std::uint32_t node);
    void collect_below(std::uint32_t first);
    void record(Commands& commands);
    std::size_t carry_out();

    World& world_;
    HierarchyNodes nodes_{{&component_info<Parent>()}};
    std::uint32_t since_ = 0;
    Observers* followed_ = nullptr;
    Commands commands_;            ///< of carry_out()
    std::vector<Entity> orphans_;  ///< children whose parent was found dead, some of them perhaps no more
    std::vector<std::uint32_t> stack_;
    std::vector<Entity> ending_;  ///< with freed_: what record() records
    std::vector<Entity> freed_;
};

}  // namespace rambla::ecs
