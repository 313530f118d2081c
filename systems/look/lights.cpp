#include "systems/look/lights.h"

#include <cmath>

namespace rambla::systems {
namespace {

bool shines(const LocalLight& light) {
    const bool any = light.intensity.x > 0.0f || light.intensity.y > 0.0f || light.intensity.z > 0.0f;
    return any && light.radius_m > 0.0f;
}

}  // namespace

FrameLight frame_light(const LocalLight& light, const Placement& placement) {
    // In double, so that the square of a tiny or huge axis neither vanishes nor overflows.
    const glm::dvec3 forward = -glm::dvec3{placement.linear[2]};
    const double size = std::sqrt(glm::dot(forward, forward));
    const bool has_direction = size > 0.0 && std::isfinite(size);
    return {.position_m = placement.translation_m,
            .radius_m = light.radius_m,
            .intensity = light.intensity,
            .cos_outer = light.cos_outer,
            .direction = has_direction ? glm::vec3{forward / size} : glm::vec3{0.0f, -1.0f, 0.0f},
            .cos_inner = light.cos_inner};
}

std::uint32_t LightSearch::operator()(ecs::World& world, const Observer& observer, const CullVolume& volume,
                                      std::vector<FrameLight>& found) {
    found.clear();
    std::uint32_t count = 0;
    for (auto [now, lights, before] : lights_.chunks(world)) {
        count += static_cast<std::uint32_t>(lights.size());
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (!shines(lights[i])) continue;
            const Placement place =
                before.empty() ? placement(now[i], observer) : placement(before[i].value, now[i], observer);
            if (!sphere_may_be_seen(volume, place.translation_m, lights[i].radius_m)) continue;
            found.push_back(frame_light(lights[i], place));
        }
    }
    return count;
}

}  // namespace rambla::systems
