#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ecs/snapshot_error.h"
#include "ecs/world.h"
#include "systems/components.h"

namespace rambla::systems {

/// Resource: the place that a saved state was simulated in. A state is worth nothing elsewhere: it names
/// links of the place's paths, and meshes and materials of its scene.
struct SavedPlace {
    std::string scene;
    std::uint64_t seed = 0;
    WorldPosition origin;
    std::string time = "noon";  ///< of day, see assets::to_text(): it decides which lamps there are
};

/// The simulation's state as bytes: all entities and the Clock. What follows from the place (Paths, Sunlight,
/// MaterialFacts, TextureUses, ClipLibrary) is not in it.
[[nodiscard]] std::vector<std::byte> save_state(ecs::World& world, const SavedPlace& place);

/// The world as it was saved. Stepped on, it gives the same bits as one that was never saved.
/// @param spawned  a world into which the same place was just spawned; what follows from the place is taken
///                 from it, the rest of it is left alone
/// Throws ecs::SnapshotError if the bytes are not right or of another place.
[[nodiscard]] std::unique_ptr<ecs::World> load_state(std::span<const std::byte> bytes,
                                                     const ecs::World& spawned, const SavedPlace& place);

}  // namespace rambla::systems
