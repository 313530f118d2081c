#include <algorithm>
#include <cmath>

#include "assets/generate/canvas.h"
#include "assets/generate/noise.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

/// A leaf of a plane tree about the origin, stalk along −y: 1 inside its outline of five lobes, 0 outside,
/// and how close the nearest vein is.
struct LeafSample {
    bool inside = false;
    float vein = 0.0f;
};

LeafSample leaf_at(glm::vec2 p) {
    const float radius = glm::length(p);
    if (radius > 1.0f) return {};
    const float angle = std::atan2(p.x, p.y);  // 0 at the tip
    constexpr float k_lobe_rad = 0.78f;
    const float lobe = angle / k_lobe_rad;
    const float nearest = std::round(std::clamp(lobe, -2.0f, 2.0f));
    const float off = std::abs(lobe - nearest);
    const float lobe_length = nearest == 0.0f ? 1.0f : (std::abs(nearest) < 1.5f ? 0.90f : 0.62f);
    const float outline = lobe_length * (1.0f - 1.05f * std::min(off, 0.62f));
    const bool stalk = std::abs(p.x) < 0.03f && p.y < 0.0f && p.y > -0.75f;
    const float vein = std::exp(-off * radius * 22.0f);
    return {radius < outline || stalk, vein};
}

}  // namespace

PaintedSet paint_leaves(std::uint32_t seed) {
    constexpr std::uint32_t k_size = 256;
    constexpr std::uint32_t k_leaves = 34;
    Canvas canvas{k_size * k_leaf_cells, k_size};
    canvas.paint([&](glm::vec2 uv) {
        const auto cell = static_cast<std::uint32_t>(uv.x * static_cast<float>(k_leaf_cells));
        const glm::vec2 local{glm::fract(uv.x * static_cast<float>(k_leaf_cells)), uv.y};
        const std::uint32_t leaf_seed = seed + 100 * cell;
        // The gaps keep the green of the leaves, so that filtering draws no dark seams around them.
        Texel texel{{0.34f, 0.44f, 0.17f, 0.0f}, 0.0f, 0.6f};
        for (std::uint32_t i = 0; i < k_leaves; ++i) {
            const float turn = 6.2831853f * lattice_unit(i, 0, leaf_seed);
            const float reach = 0.33f * std::sqrt(lattice_unit(i, 1, leaf_seed));
            const float where = 6.2831853f * lattice_unit(i, 2, leaf_seed);
            const float size = 0.15f + 0.05f * lattice_unit(i, 3, leaf_seed);
            const glm::vec2 centre{0.5f + reach * std::cos(where), 0.5f + reach * std::sin(where)};
            const glm::vec2 d = (local - centre) / size;
            const glm::vec2 p{d.x * std::cos(turn) + d.y * std::sin(turn),
                              d.y * std::cos(turn) - d.x * std::sin(turn)};
            const LeafSample leaf = leaf_at(p);
            if (!leaf.inside) continue;
            const float tone = lattice_unit(i, 4, leaf_seed);
            glm::vec3 green = glm::mix(glm::vec3{0.25f, 0.37f, 0.13f}, glm::vec3{0.50f, 0.57f, 0.22f}, tone);
            green = glm::mix(green, glm::vec3{0.58f, 0.64f, 0.32f}, 0.55f * leaf.vein);
            green *= 0.82f +
                     0.18f * static_cast<float>(i) / static_cast<float>(k_leaves);  // lower leaves are shaded
            texel = {{green, 1.0f}, 0.0f, 0.6f};
        }
        return texel;
    });
    return {"leaves", canvas.colour_image("leaves"), {}, {}, {}};
}

PaintedSet paint_railing(std::uint32_t seed) {
    // One metre of wrought iron: bars every 1/9 m, rails below and above, rings between the bars' feet and
    // heads.
    Canvas canvas{512, 512};
    canvas.paint([&](glm::vec2 uv) {
        constexpr float k_bars = 9.0f;
        const float from_bar = std::abs(glm::fract(uv.x * k_bars) - 0.5f) / k_bars;  // metres
        const auto strip = [](float distance, float half) {
            return distance < half;
        };
        const glm::vec2 ring_local{(glm::fract(uv.x * k_bars + 0.5f) - 0.5f) / k_bars, 0.0f};
        const auto ring = [&](float y) {
            return std::abs(glm::length(glm::vec2{ring_local.x, uv.y - y}) - 0.040f) < 0.0065f;
        };
        const bool knob = glm::length(glm::vec2{from_bar, (uv.y - 0.5f) * 0.7f}) < 0.019f;
        const bool iron = strip(from_bar, 0.0105f) || strip(std::abs(uv.y - 0.965f), 0.014f) ||
                          strip(std::abs(uv.y - 0.015f), 0.015f) || strip(std::abs(uv.y - 0.125f), 0.008f) ||
                          strip(std::abs(uv.y - 0.86f), 0.008f) || ring(0.07f) || ring(0.912f) || knob;
        const float rust = fractal_noise(uv, {16, 16}, 3, seed);
        const float value = 0.16f + 0.06f * (rust - 0.5f);
        return Texel{{value * 1.05f, value, value * 0.97f, iron ? 1.0f : 0.0f}, 0.0f, 0.6f};
    });
    return {"railing", canvas.colour_image("railing"), {}, {}, {}};
}

}  // namespace rambla::assets::generate
