#pragma once

#include <cstdint>
#include <tuple>

#include "ecs/component.h"
#include "ecs/entity.h"

namespace rambla::ecs {

/// What becomes of a child when its parent ends (Hierarchy::destroy, Hierarchy::end_orphans).
enum class OnParentEnd : std::uint8_t {
    destroyed,  ///< ends too, with all that hangs from it
    freed,      ///< loses its Parent and lives on as a root
};

/// Component of children. Entities with different parents share an archetype: the parent is a value, not a
/// part of the signature. The null entity as parent means a root. A parent lives in the same world: handles
/// do not tell worlds apart, so that one of another world is taken for whatever has its number here.
struct Parent {
    Entity entity;  ///< the parent
    OnParentEnd on_end = OnParentEnd::destroyed;
};

template <>
struct entity_members<Parent> {
    static constexpr std::tuple value{&Parent::entity};
};

}  // namespace rambla::ecs
