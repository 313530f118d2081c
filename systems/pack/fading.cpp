#include "systems/pack/fading.h"

#include <algorithm>
#include <cmath>

#include "ecs/query.h"

namespace rambla::systems {

std::uint8_t faded(float opacity) {
    if (!(opacity > 0.0f)) return k_faded_away;
    return static_cast<std::uint8_t>(std::lround((1.0f - std::min(opacity, 1.0f)) * 255.0f));
}

float near_opacity(const NearFade& fade, float distance_m) {
    if (distance_m <= fade.gone_m) return 0.0f;
    if (!(distance_m < fade.whole_m)) return 1.0f;
    return (distance_m - fade.gone_m) / (fade.whole_m - fade.gone_m);
}

float distance_to_box(glm::vec3 centre_m, glm::vec3 half_extents_m) {
    const glm::vec3 outside = glm::abs(centre_m) - half_extents_m;
    if (std::isnan(outside.x + outside.y + outside.z)) return std::nanf("");
    const glm::dvec3 beyond{glm::max(outside, glm::vec3{0.0f})};  // squares of far things must not overflow
    return static_cast<float>(std::sqrt(glm::dot(beyond, beyond)));
}

std::uint8_t faded(const LookChunk& chunk, std::size_t row, const LocalBounds& box) {
    if (chunk.opacities.empty() && chunk.near_fades.empty()) return 0;
    float opacity = chunk.opacities.empty() ? 1.0f : chunk.opacities[row].value;
    if (!chunk.near_fades.empty())
        opacity *= near_opacity(chunk.near_fades[row], distance_to_box(box.centre_m, box.half_extents_m));
    return faded(opacity);
}

std::vector<std::uint32_t> fading_materials(const ecs::World& world) {
    std::vector<std::uint32_t> materials;
    const auto note = [&](const Renderable& drawn) {
        materials.push_back(drawn.material);
    };
    ecs::Query<const Renderable, ecs::With<Opacity>>{}.each(world, note);
    ecs::Query<const Renderable, ecs::With<NearFade>>{}.each(world, note);
    std::sort(materials.begin(), materials.end());
    materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
    return materials;
}

}  // namespace rambla::systems
