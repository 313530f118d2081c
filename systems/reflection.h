#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "assets/place.h"
#include "ecs/reflect.h"
#include "ecs/type_registry.h"
#include "systems/components.h"

namespace rambla::systems {

/// Every component of the engine, and the resources that a saved state holds (saved_state.h).
[[nodiscard]] ecs::TypeRegistry component_registry();

}  // namespace rambla::systems

/// GLM's types, as fields of components.
template <>
struct rambla::ecs::reflection<glm::vec2> {
    static constexpr auto value =
        describe<glm::vec2>("vec2").field("x", &glm::vec2::x).field("y", &glm::vec2::y);
};
template <>
struct rambla::ecs::reflection<glm::vec3> {
    static constexpr auto value = describe<glm::vec3>("vec3")
                                      .field("x", &glm::vec3::x)
                                      .field("y", &glm::vec3::y)
                                      .field("z", &glm::vec3::z);
};
template <>
struct rambla::ecs::reflection<glm::ivec3> {
    static constexpr auto value = describe<glm::ivec3>("ivec3")
                                      .field("x", &glm::ivec3::x)
                                      .field("y", &glm::ivec3::y)
                                      .field("z", &glm::ivec3::z);
};
template <>
struct rambla::ecs::reflection<glm::quat> {
    static constexpr auto value = describe<glm::quat>("quat")
                                      .field("x", &glm::quat::x)
                                      .field("y", &glm::quat::y)
                                      .field("z", &glm::quat::z)
                                      .field("w", &glm::quat::w);
};
template <>
struct rambla::ecs::reflection<glm::mat3> {
    static constexpr auto value = describe<glm::mat3>("mat3").elements<float>("columns");
};
