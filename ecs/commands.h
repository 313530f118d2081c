#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

#include "ecs/command_arena.h"
#include "ecs/component.h"
#include "ecs/entity.h"
#include "ecs/world.h"

namespace rambla::ecs {

/// What Commands::apply did.
struct Playback {
    std::size_t applied = 0;
    std::size_t dropped = 0;  ///< target no longer alive, or component to remove not there
};

/// Structural changes recorded now and made later, in the order of their recording: for use inside loops over
/// chunks. Recording does not touch any world.
///
/// create() returns a placeholder that later commands of the same recording take as an Entity; members listed
/// in entity_members<C> may hold it too. apply() turns them into the entities made, which created() tells.
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
        record(Kind::add, entity, value);
    }
    template <Component C>
    void remove(Entity entity);
    void destroy(Entity entity) { push({Kind::destroy, 0, entity, nullptr}); }

    /// Makes the changes and empties the recording. Commands whose target ended earlier, or that remove what
    /// is not there, are dropped and counted. Throws Misuse while the world is being iterated: then nothing
    /// is changed and the recording stays. Throws CapacityExceeded: what came before it stays made, the rest
    /// is dropped.
    Playback apply(World& world);
    /// Forgets what was recorded.
    void clear() noexcept;
    [[nodiscard]] bool empty() const { return commands_.empty(); }
    [[nodiscard]] std::size_t size() const { return commands_.size(); }

    /// The entity that the last apply() made for a placeholder. Throws Misuse if there is none.
    [[nodiscard]] Entity created(Entity placeholder) const;

private:
    enum class Kind : std::uint8_t { create, add, remove, destroy };

    struct Value {
        const ComponentInfo* info;
        void* bytes;  ///< in the arena; null for tags and for removals
        /// Puts the entities made for the placeholders that the value holds; null if it holds no entities.
        void (*resolve)(const Commands& commands, void* value);
    };
    struct Command {
        Kind kind;
        std::uint32_t value_count;
        Entity entity;
        Value* values;
    };

    void push(const Command& command) { commands_.push_back(command); }
    template <class... Cs>
    void record(Kind kind, Entity entity, Cs&... values);
    template <class C>
    static void store(Value& slot, C& value) noexcept;
    template <class C>
    static void resolve(const Commands& commands, void* value);
    /// The entity made for a placeholder, if it is one of those made so far.
    [[nodiscard]] Entity resolved(Entity entity) const;

    bool play(World& world, const Command& command);
    void play_create(World& world, const Command& command);
    void resolve_values(const Command& command) const;
    static void end_values(const Command& command) noexcept;
    static void relocate(const Value& value, void* to) noexcept;
    void forget_from(std::size_t first) noexcept;

    CommandArena arena_;
    std::vector<Command> commands_;
    std::vector<Entity> created_;  ///< by placeholder, of the last apply()
    std::vector<ComponentId> signature_;
    std::uint32_t placeholders_ = 0;
};

// ----------------------------------------------------------------------------------------------------

template <class... Cs>
Entity Commands::create(Cs... values) {
    (detail::explain_component<Cs>(), ...);
    static_assert(detail::k_all_differ<Cs...>, "an entity has each component once");
    const Entity placeholder{placeholders_, 0};
    record(Kind::create, placeholder, values...);
    ++placeholders_;
    return placeholder;
}

template <Component C>
void Commands::remove(Entity entity) {
    Value* value =
        new (arena_.take(sizeof(Value), alignof(Value))) Value{&component_info<C>(), nullptr, nullptr};
    push({Kind::remove, 1, entity, value});
}

template <class... Cs>
void Commands::record(Kind kind, Entity entity, Cs&... values) {
    constexpr std::size_t count = sizeof...(Cs);
    Value* slots = nullptr;
    if constexpr (count != 0) {
        slots = static_cast<Value*>(arena_.take(count * sizeof(Value), alignof(Value)));
        std::size_t next = 0;
        ((new (slots + next++) Value{&component_info<Cs>(),
                                     is_tag<Cs> ? nullptr : arena_.take(sizeof(Cs), alignof(Cs)), nullptr}),
         ...);
    }
    push({kind, static_cast<std::uint32_t>(count), entity, slots});
    std::size_t next = 0;  // nothing fails from here on
    (store(slots[next++], values), ...);
}

template <class C>
void Commands::store(Value& slot, C& value) noexcept {
    if constexpr (!is_tag<C>) std::construct_at(static_cast<C*>(slot.bytes), std::move(value));
    if constexpr (requires { entity_members<C>::value; }) slot.resolve = &resolve<C>;
}

template <class C>
void Commands::resolve(const Commands& commands, void* value) {
    C& component = *static_cast<C*>(value);
    std::apply([&](auto... members) { ((component.*members = commands.resolved(component.*members)), ...); },
               entity_members<C>::value);
}

}  // namespace rambla::ecs
