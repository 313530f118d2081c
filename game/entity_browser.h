#pragma once

#include <cstddef>
#include <cstdint>

#include "ecs/inspect.h"
#include "ecs/type_registry.h"
#include "ecs/world.h"

namespace rambla::game {

/// Looks into a world: its archetypes, their entities, and the components of one, whose real numbers and
/// truth values can be changed.
class EntityBrowser {
public:
    /// @param world  must outlive this
    explicit EntityBrowser(ecs::World& world);

    /// Builds the widgets in the current Dear ImGui window. Between steps: no system may run meanwhile.
    void draw();

    /// The entity whose components are shown; one that has ended is none.
    [[nodiscard]] ecs::Entity chosen() const { return chosen_; }

private:
    void list_archetypes();
    void list_entities();
    void show_components();
    void show_component(const ecs::InspectedComponent& component);
    void show_struct(const ecs::InspectedComponent& component, const ecs::StructDescription& description,
                     std::size_t offset);
    void show_element(const ecs::InspectedComponent& component, const ecs::FieldDescription& field,
                      std::uint32_t element, std::size_t offset);
    void set(const ecs::InspectedComponent& component, const ecs::FieldDescription& field,
             std::uint32_t element, std::size_t offset, const ecs::FieldValue& value);

    ecs::World& world_;
    ecs::TypeRegistry registry_;
    std::size_t archetype_ = 0;
    ecs::Entity chosen_;
    ecs::Entity shown_;
};

}  // namespace rambla::game
