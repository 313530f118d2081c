#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ecs/component.h"
#include "ecs/reflect.h"
#include "ecs/resources.h"
#include "ecs/stored_row.h"

namespace rambla::ecs {

/// A component type as snapshots and inspectors know it.
struct ComponentType {
    std::string_view name;                           ///< in snapshots
    const StructDescription* description = nullptr;  ///< null for transient ones
    const ComponentInfo* info = nullptr;             ///< how worlds store it
    /// Makes default values in raw memory; null for tags.
    void (*construct)(void* first, std::size_t count) = nullptr;

    /// Its values are not saved: entities come back with default ones.
    [[nodiscard]] bool transient() const { return description == nullptr; }
};

/// A resource type as snapshots and inspectors know it.
struct ResourceType {
    using Value = std::unique_ptr<void, void (*)(void*)>;

    const StructDescription* description = nullptr;
    void* (*find)(const Resources& resources) = nullptr;  ///< null where there is none
    Value (*make)() = nullptr;                            ///< a default one
    /// Moves the value into the world's resource, which cannot fail if the world has one already.
    void (*set)(Resources& resources, void* value) = nullptr;
};

/// The types that a program saves and shows: filled by the program at its beginning, then only read. Names
/// are unique; a second type under a name throws Misuse.
class TypeRegistry {
public:
    /// Upgrades one object from the fields that were stored; fields of equal name, kind and count are filled
    /// in already, the others hold their defaults.
    using Migration = std::function<void(const StoredRow& stored, void* object)>;

    /// Saves a component with its described fields; a tag with its name.
    template <Component C>
    requires Reflected<C>
    void add() {
        const StructDescription& description = description_of<C>();
        insert(component_type<C>(description.name, &description));
        add_enable_state<C>(description.name);
    }
    /// Entities keep the component in a snapshot, but not its value: for caches and handles.
    template <Component C>
    void add_transient(std::string_view name) {
        static_assert(storage_of<C> != Storage::shared, "shared values tell archetypes apart");
        insert(component_type<C>(name, nullptr));
        add_enable_state<C>(name);
    }
    /// Saves a resource with its described fields.
    template <Reflected R>
    void add_resource();

    /// How to read objects that were stored as version `from` of T, where matching fields by name does not
    /// do. Older versions without a migration match by name: what is new keeps its default, what is gone is
    /// dropped, and a field of another kind or count is refused.
    /// @param upgrade  void(const StoredRow& stored, T& object)
    template <Reflected T, class F>
    void migrate(std::uint32_t from, F upgrade) {
        migrations_[key(description_of<T>().name, from)] = [upgrade](const StoredRow& stored, void* object) {
            upgrade(stored, *static_cast<T*>(object));
        };
    }

    /// In the order in which they were added.
    [[nodiscard]] const std::vector<ComponentType>& components() const { return components_; }
    /// In the order in which they were added.
    [[nodiscard]] const std::vector<ResourceType>& resources() const { return resources_; }
    /// Null where there is none.
    [[nodiscard]] const ComponentType* component(std::string_view name) const;
    /// By type instead of name; null where there is none.
    [[nodiscard]] const ComponentType* component(const ComponentInfo& info) const;
    /// Null where there is none.
    [[nodiscard]] const ResourceType* resource(std::string_view name) const;
    /// How to read version `from` of a type; null if by names.
    [[nodiscard]] const Migration* migration(std::string_view name, std::uint32_t from) const;

private:
    /// Which rows are switched off is saved beside the component, under "<name>.disabled".
    template <class C>
    void add_enable_state(std::string_view name);
    template <class C>
    static ComponentType component_type(std::string_view name, const StructDescription* description);
    static std::string key(std::string_view name, std::uint32_t version) {
        return std::string{name} + '/' + std::to_string(version);
    }
    void insert(const ComponentType& type);
    void insert(const ResourceType& type);

    std::vector<ComponentType> components_;
    std::vector<ResourceType> resources_;
    std::unordered_map<std::string, Migration> migrations_;
};

// ----------------------------------------------------------------------------------------------------

template <class C>
ComponentType TypeRegistry::component_type(std::string_view name, const StructDescription* description) {
    static_assert(std::is_default_constructible_v<C>, "what is not saved comes back as a default value");
    ComponentType type{name, description, &component_info<C>(), nullptr};
    if constexpr (!is_tag<C>) {
        type.construct = [](void* first, std::size_t count) {
            std::uninitialized_value_construct_n(static_cast<C*>(first), count);
        };
    }
    return type;
}

template <class C>
void TypeRegistry::add_enable_state(std::string_view name) {
    if constexpr (has_enable_bit<C>) {
        using State = EnableState<C>;
        static const std::string state_name = std::string{name} + ".disabled";
        static const StructDescription description{.name = state_name,
                                                   .version = 1,
                                                   .size = sizeof(State),
                                                   .trivially_copyable = true,
                                                   .fields = {{.name = "disabled",
                                                               .kind = FieldKind::boolean,
                                                               .stride = sizeof(State),
                                                               .options = {},
                                                               .values = {}}}};
        static_assert(sizeof(State) == 1 && std::is_trivially_copyable_v<State>);
        insert(component_type<State>(state_name, &description));
    }
}

template <Reflected R>
void TypeRegistry::add_resource() {
    static_assert(std::is_nothrow_move_assignable_v<R>, "restoring must not fail half-way");
    insert(ResourceType{.description = &description_of<R>(),
                        .find = [](const Resources& resources) -> void* { return resources.find<R>(); },
                        .make =
                            [] {
                                return ResourceType::Value{new R{}, [](void* value) {
                                                               delete static_cast<R*>(value);
                                                           }};
                            },
                        .set =
                            [](Resources& resources, void* value) {
                                resources.set<R>(std::move(*static_cast<R*>(value)));
                            }});
}

}  // namespace rambla::ecs
