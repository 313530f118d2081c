#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "ecs/command.h"
#include "ecs/command_list.h"
#include "ecs/component.h"
#include "ecs/entity.h"
#include "ecs/whole_commands.h"
#include "ecs/world.h"

namespace rambla::ecs {

/// What Commands::apply did.
struct Playback {
    std::size_t applied = 0;  ///< commands
    std::size_t dropped = 0;  ///< target no longer alive, or component to remove not there
};

/// Structural changes recorded now and made later: for use inside loops over chunks. Recording does not touch
/// any world.
///
/// create() returns a placeholder that later commands of the same recording take as an Entity; members listed
/// in entity_members<C> may hold it too. apply() turns them into the entities made, which created() tells.
///
/// Played back, every entity has what it would have if the commands were made one by one, and the same
/// commands are dropped; but all commands of one entity become one move. Rows come out in an order that
/// depends on nothing but the recording and the world:
///   - gaps that leaving rows make are filled, from the lowest gap on, with the rows behind the new end, from
///     the lowest of them on;
///   - rows that come from other archetypes follow behind, by the age of the archetype that they come from,
///     then in the order that they had there; but in the order of the commands where these are at least 32,
///     all the same, and about different entities of one archetype, in a world without observers, of a
///     component that has a column or is a tag (but not where one is added that holds entities);
///   - created entities come last, in the order of their creation.
/// Commands for all entities are played where they stand among the others. Their rows keep their order behind
/// those that were there.
/// Handles: those of destroyed entities become free, in the order of their archetypes and rows, before those
/// of created entities are taken, in the order of creation.
class Commands {
public:
    Commands() = default;
    ~Commands() { clear(); }
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    /// An entity with these components, made in its final archetype. Returns a placeholder.
    template <class... Cs>
    Entity create(Cs... values);
    /// Gives a component, or replaces the value that is there then.
    template <Component C>
    void add(Entity entity, C value = {}) {
        record(detail::command_type<detail::CommandKind::add, C>(), entity, value);
    }
    /// Takes a component away. Dropped and counted when played if it is not there then.
    template <Component C>
    void remove(Entity entity) {
        record(detail::command_type<detail::CommandKind::remove, C>(), entity);
    }
    /// Ends an entity. Dropped and counted when played if it ended before.
    void destroy(Entity entity) { record(detail::command_type<detail::CommandKind::destroy>(), entity); }
    /// destroy() for each, in their order.
    void destroy_many(std::span<const Entity> entities) {
        for (Entity entity : entities)
            destroy(entity);
    }

    /// Gives C, or replaces its value, to all entities that fit the terms when it is played:
    ///     commands.add_to_all<Frozen, With<Health>, Without<Burning>>();
    /// Whole archetypes change, and where the one that they change to is empty, without moving a row. Terms
    /// are those that whole archetypes fit; without any, all entities do.
    template <Component C, class... Terms>
    void add_to_all(C value = {}) {
        record(detail::whole_command_type<detail::CommandKind::add, C, Terms...>(), Entity{}, value);
    }
    /// Takes C from all entities that have it and fit the terms.
    template <Component C, class... Terms>
    void remove_from_all() {
        record(detail::whole_command_type<detail::CommandKind::remove, C, Terms...>(), Entity{});
    }
    /// Ends all entities that fit the terms.
    template <class... Terms>
    void destroy_all() {
        record(detail::whole_destroy_type<Terms...>(), Entity{});
    }

    /// Makes the changes and empties the recording. Commands whose target ended earlier, or that remove what
    /// is not there, are dropped and counted. Throws Misuse while the world is being iterated: then nothing
    /// is changed and the recording stays. Throws CapacityExceeded: then nothing is changed and the recording
    /// is dropped; except that commands for all entities divide a recording, and that what came before the
    /// part that does not fit stays made. Rows that come to an archetype need room beside rows that go. What
    /// observers throw comes when all changes are made.
    Playback apply(World& world);
    /// Forgets what was recorded.
    void clear() noexcept;
    /// Whether nothing is recorded.
    [[nodiscard]] bool empty() const { return list_.empty(); }
    /// Number of commands recorded; one for all entities counts as one.
    [[nodiscard]] std::size_t size() const { return list_.size(); }

    /// Memory held, without what values recorded own.
    [[nodiscard]] std::size_t memory_bytes() const;

    /// The entity that the last apply() made for a placeholder. Throws Misuse if there is none.
    [[nodiscard]] Entity created(Entity placeholder) const;

private:
    friend class detail::CommandPlayer;

    template <class... Cs>
    void record(const detail::CommandType& type, Entity entity, Cs&... values);
    /// Forgets the commands from `first` on and ends their values; those before it have none left.
    void forget_from(std::size_t first) noexcept;

    detail::CommandList list_;
    std::vector<Entity> created_;  ///< by placeholder, of the last apply()
    std::uint32_t placeholders_ = 0;
};

// ----------------------------------------------------------------------------------------------------

template <class... Cs>
Entity Commands::create(Cs... values) {
    (detail::explain_component<Cs>(), ...);
    static_assert(detail::k_all_differ<Cs...>, "an entity has each component once");
    const Entity placeholder{placeholders_, 0};
    record(detail::command_type<detail::CommandKind::create, Cs...>(), placeholder, values...);
    ++placeholders_;
    return placeholder;
}

template <class... Cs>
void Commands::record(const detail::CommandType& type, Entity entity, Cs&... values) {
    using Layout = detail::CommandLayout<Cs...>;
    [[maybe_unused]] std::byte* const bytes = list_.push(entity, type, Layout::stride, Layout::alignment);
    [[maybe_unused]] std::size_t next = 0;  // nothing fails from here on
    [[maybe_unused]] const auto store = [&]<class C>(C& value) {
        const std::size_t offset = Layout::offsets[next++];
        if constexpr (!is_tag<C>) std::construct_at(reinterpret_cast<C*>(bytes + offset), std::move(value));
    };
    (store(values), ...);
}

}  // namespace rambla::ecs
