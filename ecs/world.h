#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "ecs/access_scope.h"
#include "ecs/archetype_graph.h"
#include "ecs/archetype_stats.h"
#include "ecs/component.h"
#include "ecs/entity.h"
#include "ecs/entity_table.h"
#include "ecs/iteration.h"
#include "ecs/misuse.h"
#include "ecs/resources.h"

namespace rambla::ecs {

template <class... Terms>
class Query;
class Commands;
class Observers;
namespace detail {
class CommandPlayer;
std::span<const Entity> announce(World& world, std::span<const Entity> entities);
}  // namespace detail

/// Limits and memory of a world. Address space is reserved by them, memory is not.
struct WorldOptions {
    /// Alive at one time; at most 2³² − 1.
    std::uint32_t max_entities = 1u << 28u;
    /// Rounded up to 16; at most 2³¹. A column reserves this times its component's size.
    std::uint32_t max_rows_per_archetype = 1u << 24u;
    /// The world's first version() of changes.
    std::uint32_t first_version = 1;
    /// False: archetypes grow by allocating anew and moving their rows.
    bool reserve_address_space = true;
    /// Where rows of small archetypes, sparse and shared values come from, in slabs of 64 KiB and large
    /// blocks; null: the heap. Outlives the world. Rows of larger archetypes and entity records have address
    /// ranges of their own, tables come from the heap.
    std::pmr::memory_resource* memory = nullptr;
};

/// Entities, their components and the world's resources.
///
/// References to components stay valid until the next structural change (create, destroy, add, remove,
/// commands). Structural changes while this thread walks over a query's chunks, or works for a system of a
/// schedule that shares the world with others, throw Misuse; record them in Commands. A world may be read by
/// several threads at once, or changed by one.
class World {
public:
    explicit World(const WorldOptions& options = {});
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// An entity without components.
    Entity create() { return create_in(empty_archetype()).entity; }
    /// An entity with these components, which lands directly in its archetype. Throws CapacityExceeded.
    template <class... Cs>
    requires(sizeof...(Cs) > 0) Entity create(Cs... values);
    /// Ends the entity and its components. Throws Misuse on a stale handle.
    void destroy(Entity entity);
    /// Whether the handle is one of a living entity. Any handle will do.
    [[nodiscard]] bool alive(Entity entity) const { return entities_.find(entity) != nullptr; }

    /// Gives the entity a component, or replaces the value it has. Throws Misuse on a stale handle.
    template <Component C>
    void add(Entity entity, C value = {});
    /// Takes the component away. Throws Misuse on a stale handle or when it is not there.
    template <Component C>
    void remove(Entity entity);
    /// Whether the entity has the component, tags included. Throws Misuse on a stale handle.
    template <Component C>
    [[nodiscard]] bool has(Entity entity) const;

    /// Switches a component with an enable bit off or on, without moving the entity: terms Enabled and
    /// Disabled tell the difference, nothing else. A component is enabled when it is added; replacing its
    /// value changes nothing. No structural change, but a write. Throws Misuse on a stale handle or when the
    /// component is not there.
    template <Component C>
    requires(has_enable_bit<C>) void set_enabled(Entity entity, bool enabled);
    /// Whether the component is switched on. Throws Misuse on a stale handle or when it is not there.
    template <Component C>
    requires(has_enable_bit<C>) [[nodiscard]] bool enabled(Entity entity) const;

    /// The component's value. Throws Misuse on a stale handle or when the component is not there.
    template <Component C>
    [[nodiscard]] const C& get(Entity entity) const;
    /// The same for writing: counts as a change of the row's chunk.
    template <Component C>
    [[nodiscard]] C& get_mut(Entity entity);
    /// Null when the component is not there. Throws Misuse on a stale handle.
    template <Component C>
    [[nodiscard]] const C* try_get(Entity entity) const;
    /// The same for writing: where the component is there, counts as a change of the row's chunk.
    template <Component C>
    [[nodiscard]] C* try_get_mut(Entity entity);

    /// Counts the component as written without touching it. Throws Misuse on a stale handle or when the
    /// component is not there.
    template <Component C>
    void mark_changed(Entity entity) {
        (void)get_mut<C>(entity);
    }

    /// Calls f(i, const C&) for each of the entities in turn, i counting them. Faster than single gets where
    /// values lie scattered: later ones are on their way while f has an earlier one. Throws Misuse on a stale
    /// handle or when the component is not there; f may have had entities before it. f makes no structural
    /// changes.
    template <Component C, class F>
    void get_many(std::span<const Entity> entities, F&& f) const;
    /// The same for writing, f(i, C&): counts as a change of the rows' chunks.
    template <Component C, class F>
    void get_many_mut(std::span<const Entity> entities, F&& f);

    /// Sets or replaces the world's one R. Throws Misuse in a system of a schedule that shares the world.
    template <class R>
    R& set_resource(R value) {
        detail::AccessScope::require_alone(*this, "set_resource");
        return resources_.set<R>(std::move(value));
    }
    /// The world's one R. Throws Misuse if it was never set.
    template <class R>
    [[nodiscard]] R& resource() {
        detail::AccessScope::check<R>(*this, AccessKind::resource, true);
        return resources_.get<R>();
    }
    /// The same for reading.
    template <class R>
    [[nodiscard]] const R& resource() const {
        detail::AccessScope::check<R>(*this, AccessKind::resource, false);
        return resources_.get<R>();
    }
    /// Whether R was ever set.
    template <class R>
    [[nodiscard]] bool has_resource() const {
        return resources_.find<R>() != nullptr;
    }

    /// Functions that are called when components come and go. Throws Misuse in a system of a schedule that
    /// shares the world.
    [[nodiscard]] Observers& observers();

    /// What writes are stamped with: each chunk × component keeps the version of its last write.
    [[nodiscard]] std::uint32_t version() const { return version_; }
    /// Begins a new version, so that later writes can be told from earlier ones. Returns the one that ended.
    /// Versions wrap around after 2³². Comparisons hold for readers that look at least every 2³⁰ versions;
    /// what was written longer ago counts as written then.
    /// Throws Misuse in a system that shares the world.
    std::uint32_t advance_version() {
        detail::AccessScope::require_alone(*this, "advance_version");
        if (++version_ % k_aging_interval == 0) age_versions();
        return version_ - 1;
    }

    /// Entities alive.
    [[nodiscard]] std::size_t entity_count() const { return entities_.alive_count(); }
    /// Archetypes ever born, the empty one included.
    [[nodiscard]] std::size_t archetype_count() const { return graph_.size(); }
    /// Memory held: committed columns and pooled blocks, entity records, tables, resources. Not what
    /// components own elsewhere.
    [[nodiscard]] std::size_t memory_bytes() const;
    /// The same archetype by archetype, in the order of their birth.
    [[nodiscard]] std::vector<ArchetypeStats> archetype_stats() const;
    /// Gives back memory that no entity needs now. Handles stay valid, references do not: a structural
    /// change. Throws std::bad_alloc or CapacityExceeded when rows cannot be moved together; nothing is lost
    /// then.
    void compact();

private:
    template <class... Terms>
    friend class Query;
    friend class Commands;
    friend class Observers;
    friend std::span<const Entity> detail::announce(World& world, std::span<const Entity> entities);
    friend struct detail::WorldAccess;
    friend class detail::CommandPlayer;

    struct Created {
        Entity entity;
        std::uint32_t row;
    };
    /// Every so many versions the oldest ones are raised, so that no two are further apart than 2³⁰ plus
    /// this.
    static constexpr std::uint32_t k_aging_interval = 1u << 29u;

    /// Tells apart the component lists that create() is called with.
    template <class... Cs>
    struct Bundle {};

    [[nodiscard]] Archetype& empty_archetype() const { return graph_[0]; }
    /// The archetype of a bundle, and which of its columns the components go to, in the order of the list.
    struct BundlePlace {
        Archetype* archetype = nullptr;
        std::unique_ptr<ColumnIndex[]> columns;
    };

    template <class... Cs>
    const BundlePlace& bundle_place();
    template <class... Cs>
    const BundlePlace& make_bundle_place(std::uint32_t bundle);
    Created create_in(Archetype& archetype) {
        detail::IterationMark::forbid(*this, "create");
        entities_.reserve_one();
        archetype.reserve_one();
        const Entity entity = entities_.take(archetype.index(), archetype.rows());
        return {entity, archetype.push(entity, version_)};
    }
    /// Ends a living entity, which no observer is told.
    void end(Entity entity) noexcept;
    /// Ends a living entity of whatever components, and tells observers.
    void destroy_any(Entity entity);
    void announce_new(Entity entity, Archetype& archetype, bool has_sparse);
    /// Where to construct the component: raw memory, null for tags. Moves the entity, or ends the old value.
    void* slot_for(Entity entity, const ComponentInfo& info);
    void* sparse_slot_for(Entity entity, const ComponentInfo& info);
    void share(Entity entity, const ComponentInfo& info, const void* value);
    void take_away(Entity entity, const ComponentInfo& info);
    /// Lets observers know of a change that is going to be made. Returns whether the component has any.
    bool before_add(Entity entity, const ComponentInfo& info);
    bool before_remove(Entity entity, const ComponentInfo& info);
    void after_add();
    /// Whether a living entity has the component, whatever its storage.
    [[nodiscard]] bool holds(Entity entity, const EntityRecord& record, const ComponentInfo& info) const;
    void age_versions() noexcept;
    Archetype& move(EntityRecord& record, Archetype& to);
    template <class C>
    static void construct(Archetype& archetype, ColumnIndex column, std::uint32_t row, C& value) noexcept;
    /// Where entities of this archetype go with the value if it is shared; else the archetype itself.
    template <class C>
    Archetype* with_shared(Archetype* archetype, const C& value);
    template <class C>
    void construct_sparse(Entity entity, C& value);
    template <class C>
    [[nodiscard]] SparseSet* sparse_set() const {
        return graph_.sparse().find(graph_.find_component(type_index<C>()));
    }
    template <class C>
    [[nodiscard]] std::uint32_t sparse_place(Entity entity) const {
        const SparseSet* set = sparse_set<C>();
        return set == nullptr ? SparseSet::k_none : set->find(entity);
    }
    template <class C, class F>
    void for_many(std::string_view operation, std::span<const Entity> entities, F& f) const;
    template <class C>
    const EntityRecord& record_of(std::string_view operation, Entity entity) const;
    template <class C>
    const C* find(std::string_view operation, Entity entity) const;
    template <class C>
    C* find_mut(std::string_view operation, Entity entity);

    Resources resources_;  // first, so that components may still use them when they end
    EntityTable entities_;
    ArchetypeGraph graph_;
    std::vector<BundlePlace> bundles_;  ///< by type index of the Bundle
    std::uint64_t serial_;              ///< never used twice: how queries know the world they have cached
    std::uint32_t version_;
    std::unique_ptr<detail::CommandPlayer> player_;  ///< made by the first playback
    std::unique_ptr<Observers> observers_;           ///< made when first asked for
};

}  // namespace rambla::ecs

#include "ecs/get_many.h"
#include "ecs/world_members.h"
