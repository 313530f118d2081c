#pragma once

#include <cstdint>
#include <memory>

#include "ecs/schedule.h"
#include "systems/frame.h"
#include "systems/look/cull_kernel.h"
#include "systems/look/observer.h"

namespace rambla::systems {

/// Resource: from where the world is looked at, and what of it is asked for.
struct Look {
    Observer observer;
    CullVolume camera;
    CullVolume casters;  ///< of what may throw a shadow into the camera's picture
    bool shadows = false;
    glm::vec3 forward{0.0f, 0.0f, -1.0f};
};

/// Resource: the Frame that is being filled.
struct FrameUnderWork {
    Frame* frame = nullptr;
};

/// Resource: the systems that look and pack, with the memory that they keep from Frame to Frame.
struct Looking {
    std::unique_ptr<ecs::Schedule> schedule;
    std::uint64_t frames = 0;
};

/// Culling and lights, which may run side by side, then packing and what textures need. Needs the resources
/// Look, FrameUnderWork, MaterialFacts, TextureUses and Culling.
[[nodiscard]] Looking make_looking();

}  // namespace rambla::systems
