#include "systems/look/lights.h"

#include <cmath>

namespace rambla::systems {
namespace {

bool shines(glm::vec3 light) {
    return light.x > 0.0f || light.y > 0.0f || light.z > 0.0f;
}

glm::vec3 direction_of(const Placement& placement) {
    // In double, so that the square of a tiny or huge axis neither vanishes nor overflows.
    const glm::dvec3 forward = -glm::dvec3{placement.linear[2]};
    const double size = std::sqrt(glm::dot(forward, forward));
    const bool has_direction = size > 0.0 && std::isfinite(size);
    return has_direction ? glm::vec3{forward / size} : glm::vec3{0.0f, -1.0f, 0.0f};
}

/// @param reaches  (light, placement): whether the picture needs to know of it
/// @return         how many lights there are
template <class Lights, class Reaches>
std::uint32_t search(ecs::World& world, Lights& all, const Observer& observer, std::vector<FrameLight>& found,
                     const Reaches& reaches) {
    found.clear();
    std::uint32_t count = 0;
    for (auto [now, lights, before] : all.chunks(world)) {
        count += static_cast<std::uint32_t>(lights.size());
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const Placement place =
                before.empty() ? placement(now[i], observer) : placement(before[i].value, now[i], observer);
            if (reaches(lights[i], place)) found.push_back(frame_light(lights[i], place));
        }
    }
    return count;
}

}  // namespace

FrameLight frame_light(const LocalLight& light, const Placement& placement) {
    return {.position_m = placement.translation_m,
            .radius_m = light.radius_m,
            .intensity = light.intensity,
            .cos_outer = light.cos_outer,
            .direction = direction_of(placement),
            .cos_inner = light.cos_inner};
}

FrameLight frame_light(const DirectionalLight& light, const Placement& placement) {
    return {.intensity = light.illuminance, .direction = direction_of(placement)};
}

std::uint32_t LightSearch::operator()(ecs::World& world, const Observer& observer, const CullVolume& volume,
                                      std::vector<FrameLight>& found) {
    return search(world, lights_, observer, found, [&](const LocalLight& light, const Placement& place) {
        return shines(light.intensity) && light.radius_m > 0.0f &&
               sphere_may_be_seen(volume, place.translation_m, light.radius_m);
    });
}

std::uint32_t DirectionalLightSearch::operator()(ecs::World& world, const Observer& observer,
                                                 std::vector<FrameLight>& found) {
    return search(world, lights_, observer, found,
                  [](const DirectionalLight& light, const Placement&) { return shines(light.illuminance); });
}

}  // namespace rambla::systems
