#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include "ecs/component.h"
#include "ecs/entity.h"

namespace rambla::ecs {

class Archetype;
class ArchetypeGraph;

namespace detail {

/// What the placeholders of one recording stand for: number i stands for entities[i].
using CreatedEntities = std::span<const Entity>;

[[nodiscard]] inline Entity resolved(CreatedEntities created, Entity entity) {
    return entity.generation == 0 && entity.index < created.size() ? created[entity.index] : entity;
}

enum class CommandKind : std::uint8_t { create, add, remove, destroy };

/// One component of a command.
struct CommandPart {
    const ComponentInfo* info;
    std::uint32_t offset;  ///< of the value in the command's values
    /// Puts entities where the value holds placeholders; null if it holds no entities.
    void (*resolve)(CreatedEntities created, void* value);
};

/// All that commands written the same way share: one of these per function and list of types.
struct CommandType {
    CommandKind kind;
    bool holds_entities;  ///< some part must be resolved
    bool values_end;      ///< some part has a destructor to call
    bool beside_columns;  ///< some part is stored sparse or shared
    std::span<const CommandPart> parts;
    std::size_t stride;  ///< from one command's values to the next's where they lie one behind the other
    /// Set for commands about all entities of the archetypes that it says yes to.
    bool (*fits)(const ArchetypeGraph& graph, const Archetype& archetype) = nullptr;
    /// Constructs copies of a value, for those.
    void (*fill)(void* first, std::size_t count, const void* value) noexcept = nullptr;

    /// Whether it gives a value to, or takes a column from, the row of one entity and does nothing else.
    [[nodiscard]] bool is_about_one_column() const {
        return (kind == CommandKind::add || kind == CommandKind::remove) && !beside_columns &&
               !holds_entities && fits == nullptr;
    }
};

struct Command {
    Entity entity;
    const CommandType* type;
    std::byte* values;  ///< null where there are none
};

template <class C>
void resolve_members(CreatedEntities created, void* value) {
    C& component = *static_cast<C*>(value);
    std::apply([&](auto... members) { ((component.*members = resolved(created, component.*members)), ...); },
               entity_members<C>::value);
}

template <class C>
CommandPart command_part(std::size_t offset) {
    static_assert(
        storage_of<C> != Storage::shared || !requires { entity_members<C>::value; },
        "a shared value is known before placeholders are");
    CommandPart part{&component_info<C>(), static_cast<std::uint32_t>(offset), nullptr};
    if constexpr (requires { entity_members<C>::value; }) part.resolve = &resolve_members<C>;
    return part;
}

/// How the values of several components lie behind each other.
template <class... Cs>
struct CommandLayout {
    static constexpr std::size_t alignment = [] {
        std::size_t largest = 1;
        ((largest = !is_tag<Cs> && alignof(Cs) > largest ? alignof(Cs) : largest), ...);
        return largest;
    }();
    /// One offset per component, then the size of all.
    static constexpr std::array<std::size_t, sizeof...(Cs) + 1> offsets = [] {
        std::array<std::size_t, sizeof...(Cs) + 1> result{};
        std::size_t next = 0;
        [[maybe_unused]] std::size_t i = 0;
        [[maybe_unused]] const auto place = [&](std::size_t size, std::size_t align) {
            next = (next + align - 1) / align * align;
            result[i++] = next;
            next += size;
        };
        (place(is_tag<Cs> ? 0 : sizeof(Cs), is_tag<Cs> ? 1 : alignof(Cs)), ...);
        result[sizeof...(Cs)] = next;
        return result;
    }();
    /// All, up to where the next may begin.
    static constexpr std::size_t stride = (offsets[sizeof...(Cs)] + alignment - 1) / alignment * alignment;
};

template <CommandKind Kind, class... Cs>
struct CommandTypeOf {
    std::array<CommandPart, sizeof...(Cs)> parts;
    CommandType type{Kind,  false, false,
                     false, parts, Kind == CommandKind::remove ? 0 : CommandLayout<Cs...>::stride};

    CommandTypeOf() {
        [[maybe_unused]] std::size_t i = 0;
        parts = {command_part<Cs>(CommandLayout<Cs...>::offsets[i++])...};
        for (const CommandPart& part : parts) {
            type.beside_columns = type.beside_columns || part.info->storage != Storage::column;
            if (Kind == CommandKind::remove) continue;
            type.holds_entities = type.holds_entities || part.resolve != nullptr;
            type.values_end = type.values_end || part.info->destroy != nullptr;
        }
    }
    CommandTypeOf(const CommandTypeOf&) = delete;
    CommandTypeOf& operator=(const CommandTypeOf&) = delete;
};

/// Made before main(): a static inside the function would be asked for its guard by every command.
template <CommandKind Kind, class... Cs>
inline const CommandTypeOf<Kind, Cs...> k_command_type;

template <CommandKind Kind, class... Cs>
const CommandType& command_type() {
    return k_command_type<Kind, Cs...>.type;
}

}  // namespace detail
}  // namespace rambla::ecs
