#pragma once

#include <cstdint>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/frame.h"
#include "systems/look/cull_kernel.h"
#include "systems/look/observer.h"

namespace rambla::systems {

/// A local light as the camera meets it. A transform without direction shines downwards; scale does not
/// matter.
[[nodiscard]] FrameLight frame_light(const LocalLight& light, const Placement& placement);

/// Parallel light as the camera meets it; directions as of local lights.
[[nodiscard]] FrameLight frame_light(const DirectionalLight& light, const Placement& placement);

/// Finds the local lights whose spheres reach into a volume.
class LightSearch {
public:
    /// Replaces `found`. Lights without intensity or radius are left out.
    /// @return  number of local lights in the world
    std::uint32_t operator()(ecs::World& world, const Observer& observer, const CullVolume& volume,
                             std::vector<FrameLight>& found);

private:
    ecs::Query<const WorldTransform, const LocalLight, ecs::Optional<const PreviousWorldTransform>> lights_;
};

/// Finds the directional lights, which shine wherever one looks.
class DirectionalLightSearch {
public:
    /// Replaces `found`. Lights without illuminance are left out.
    /// @return  number of directional lights in the world
    std::uint32_t operator()(ecs::World& world, const Observer& observer, std::vector<FrameLight>& found);

private:
    ecs::Query<const WorldTransform, const DirectionalLight, ecs::Optional<const PreviousWorldTransform>>
        lights_;
};

}  // namespace rambla::systems
