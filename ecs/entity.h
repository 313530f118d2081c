#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace rambla::ecs {

/// Handle of an entity: a slot and how often that slot was used before. Living entities have generations from
/// 1; generation 0 marks the null entity and the placeholders that Commands hands out.
struct Entity {
    std::uint32_t index = 0xffffffffu;  ///< of the slot
    std::uint32_t generation = 0;       ///< of its uses

    bool operator==(const Entity&) const = default;
};

/// "12v3": index 12, generation 3; "null" for the null entity; "placeholder 4" for what Commands::create
/// returned.
[[nodiscard]] std::string to_string(Entity entity);

}  // namespace rambla::ecs

template <>
struct std::hash<rambla::ecs::Entity> {
    std::size_t operator()(rambla::ecs::Entity entity) const noexcept {
        return std::hash<std::uint64_t>{}((std::uint64_t{entity.generation} << 32u) | entity.index);
    }
};
