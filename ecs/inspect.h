#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ecs/type_registry.h"
#include "ecs/world.h"

namespace rambla::ecs {

/// A component of one entity, for those who know its type by description alone.
struct InspectedComponent {
    const ComponentType* type = nullptr;
    const void* value = nullptr;  ///< null for tags; valid until the next structural change
    /// Shared values belong to other entities too, and enable bits have summaries: neither may be written to
    /// like other fields.
    bool writable = false;
};

/// Entities of one archetype, counted as by World::archetype_stats(), in the order of their rows. Valid until
/// the next structural change.
[[nodiscard]] std::span<const Entity> entities_of_archetype(const World& world, std::size_t archetype);

/// The entity's components that the registry knows, in its order, whatever their storage. Throws Misuse on a
/// stale handle.
[[nodiscard]] std::vector<InspectedComponent> components_of(const World& world, const TypeRegistry& registry,
                                                            Entity entity);

/// The value of a writable component: counts as a change of the row's chunk, as World::get_mut does. Null
/// when the component is not there or not writable. Throws Misuse on a stale handle.
[[nodiscard]] void* component_for_writing(World& world, const ComponentType& type, Entity entity);

}  // namespace rambla::ecs
