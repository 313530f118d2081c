#include "assets/generate/shop_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/generate/form_factor.h"
#include "assets/process/srgb.h"

namespace rambla::assets::generate {

namespace {

/// Texels from the first to behind the last whose middles lie in a part of an edge, at least one.
struct TexelRange {
    std::uint32_t first, end;
};
TexelRange texels_between(float a, float b, std::uint32_t size) {
    const auto edge = static_cast<float>(size);
    const auto first = static_cast<std::uint32_t>(std::clamp(std::round(a * edge), 0.0f, edge - 1.0f));
    const auto end = static_cast<std::uint32_t>(std::clamp(std::round(b * edge), 0.0f, edge));
    return {first, std::max(end, first + 1)};
}

}  // namespace

double glow_fade(double distance, double reach) {
    const double x = std::clamp((distance / reach - 0.4) / 0.6, 0.0, 1.0);
    return 1.0 - x * x * (3.0 - 2.0 * x);
}

glm::vec3 mean_emission(const Scene& scene, std::uint32_t material, glm::vec2 a, glm::vec2 b) {
    const Material& look = scene.materials[material];
    if (look.emissive_texture.texture == k_none) return look.emissive;
    const Image& image = scene.images[scene.textures[look.emissive_texture.texture].image];
    const TexelRange columns = texels_between(std::min(a.x, b.x), std::max(a.x, b.x), image.width);
    const TexelRange rows = texels_between(std::min(a.y, b.y), std::max(a.y, b.y), image.height);
    glm::dvec3 sum{0.0};
    for (std::uint32_t y = rows.first; y < rows.end; ++y) {
        for (std::uint32_t x = columns.first; x < columns.end; ++x) {
            const std::byte* const texel = &image.texels[4 * (std::size_t{y} * image.width + x)];
            for (int c = 0; c < 3; ++c)
                sum[c] += linear_from_srgb_bytes()[std::to_integer<std::size_t>(texel[c])];
        }
    }
    const double count = static_cast<double>(rows.end - rows.first) * (columns.end - columns.first);
    return look.emissive * glm::vec3{sum / count};
}

glm::dvec3 glow_on_ground(const ShopWindow& window, glm::vec3 point_m, const GlowReach& reach) {
    const glm::dvec3 p{window.wall.local(point_m)};
    const double beside = std::max({window.opening.min.x - p.x, p.x - window.opening.max.x, 0.0});
    const double weight = glow_fade(p.z, reach.ahead_m) * glow_fade(beside, reach.beside_m);
    // The ground reaches a little below the wall, where its light is that of the wall's foot.
    constexpr double k_foot_m = 0.15, k_nearest_m = 0.01;
    if (weight <= 0.0 || p.z < -k_foot_m) return glm::dvec3{0.0};
    const double z = std::max(p.z, k_nearest_m);
    // What is seen of the pane's plane through the opening:    pane ─────┬───────┬───
    // a line from the point by its edge goes on by            jamb │     │  jamb │
    // reveal/z of its way.                                          ──────┘       └───
    //                                                                        · point
    const double beyond = 1.0 + k_reveal_m / z;
    const double seen_min = p.x + (window.opening.min.x - p.x) * beyond;
    const double seen_max = p.x + (window.opening.max.x - p.x) * beyond;
    glm::dvec3 sum{0.0};
    for (const GlowingGlass& glass : window.glass) {
        const double x0 = std::max<double>(glass.at.min.x, seen_min);
        const double x1 = std::min<double>(glass.at.max.x, seen_max);
        if (x0 >= x1) continue;
        const double y0 = glass.at.min.y, y1 = glass.at.max.y;
        const double back = -k_reveal_m;
        const std::array<glm::dvec3, 4> corners{
            {{x0, y0, back}, {x1, y0, back}, {x1, y1, back}, {x0, y1, back}}};
        sum += form_factor(corners, {p.x, p.y, z}, {0.0, 1.0, 0.0}) * glm::dvec3{glass.radiance};
    }
    return weight * sum;
}

}  // namespace rambla::assets::generate
