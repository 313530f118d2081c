#include <algorithm>
#include <array>
#include <cmath>

#include "assets/generate/canvas.h"
#include "assets/generate/noise.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

PaintedSet paint_paving(std::uint32_t seed) {
    // Barcelona's "panot": hydraulic tiles of 20 cm with a flower of four petals about a ring, pressed 8 mm
    // deep.
    constexpr std::uint32_t k_tiles = 8;
    Canvas canvas{512, 512};
    canvas.paint([&](glm::vec2 uv) {
        const glm::vec2 at = uv * static_cast<float>(k_tiles);
        const glm::uvec2 tile{at};
        const glm::vec2 local = at - glm::vec2{tile} - 0.5f;  // −0.5 … 0.5 over one tile
        const float tone = lattice_unit(tile.x, tile.y, seed);
        const float grain = fractal_noise(uv, {128, 128}, 2, seed + 1);
        const float dirt = fractal_noise(uv, {4, 4}, 5, seed + 2);

        constexpr float k_groove = 0.030f;  // half width, in tiles
        const auto groove = [&](float distance) {
            return 1.0f - glm::smoothstep(k_groove * 0.5f, k_groove, distance);
        };
        const glm::vec2 petal = glm::abs(local) - 0.175f;
        const float outside_other_petals = std::min(std::abs(local.x), std::abs(local.y));
        float pressed = groove(std::abs(glm::length(petal) - 0.175f));
        pressed *= glm::smoothstep(0.01f, 0.03f, outside_other_petals);
        const float radius = glm::length(local);
        pressed *= glm::smoothstep(0.10f, 0.12f, radius);
        pressed = std::max(pressed, groove(std::abs(radius - 0.10f)));
        const float edge = 0.5f - std::max(std::abs(local.x), std::abs(local.y));
        const float joint = 1.0f - glm::smoothstep(0.008f, 0.028f, edge);

        const float value = (0.70f + 0.06f * tone + 0.10f * (grain - 0.5f) + 0.16f * (dirt - 0.5f)) *
                            (1.0f - 0.28f * pressed) * (1.0f - 0.42f * joint);
        return Texel{{value, value * 0.965f, value * 0.90f, 1.0f},
                     -0.006f * std::max(pressed, joint) + 0.001f * grain,
                     0.72f + 0.20f * dirt};
    });
    return {"paving",
            canvas.colour_image("paving"),
            canvas.normal_image("paving-normal", 1.6f),
            canvas.roughness_image("paving-roughness"),
            {},
            canvas.relief("paving-height", 1.6f)};
}

PaintedSet paint_asphalt(std::uint32_t seed) {
    Canvas canvas{512, 512};
    canvas.paint([&](glm::vec2 uv) {
        const glm::vec2 stones = cell_noise(uv, {150, 150}, seed);
        const float tone = fractal_noise(uv, {128, 128}, 2, seed + 1);
        const float wear = fractal_noise(uv, {3, 3}, 5, seed + 2);
        const glm::vec2 blotch = cell_noise(uv + 0.02f * wear, {3, 4}, seed + 5);
        const float crack = 1.0f - glm::smoothstep(0.0f, 0.012f, blotch.y - blotch.x);
        const float stone = 1.0f - glm::smoothstep(0.15f, 0.55f, stones.x);
        const float value =
            0.42f + 0.10f * (tone - 0.5f) + 0.09f * (wear - 0.5f) + 0.05f * stone - 0.05f * crack;
        return Texel{{value, value * 0.975f, value * 0.93f, 1.0f},
                     0.0035f * stone - 0.003f * crack,
                     0.86f - 0.10f * wear};
    });
    return {"asphalt", canvas.colour_image("asphalt"), canvas.normal_image("asphalt-normal", 2.0f), {}, {}};
}

PaintedSet paint_granite(std::uint32_t seed) {
    Canvas canvas{256, 256};
    canvas.paint([&](glm::vec2 uv) {
        const float speckle = lattice_unit(static_cast<std::uint32_t>(uv.x * 256.0f),
                                           static_cast<std::uint32_t>(uv.y * 256.0f), seed);
        const float cloud = fractal_noise(uv, {6, 6}, 4, seed + 1);
        const float joint_distance = std::min(uv.x, 1.0f - uv.x) * 1.2f;  // kerb stones of 1.2 m
        const float joint = 1.0f - glm::smoothstep(0.004f, 0.010f, joint_distance);
        const float value =
            (0.68f + 0.18f * (cloud - 0.5f) + 0.12f * (speckle - 0.5f)) * (1.0f - 0.35f * joint);
        return Texel{{value, value * 0.98f, value * 0.94f, 1.0f}, 0.0f, 0.8f};
    });
    return {"granite", canvas.colour_image("granite"), {}, {}, {}};
}

PaintedSet paint_gravel(std::uint32_t seed) {
    // Roof terraces: fired tiles of 25 × 12.5 cm, faded.
    Canvas canvas{256, 256};
    canvas.paint([&](glm::vec2 uv) {
        const glm::uvec2 tile{static_cast<std::uint32_t>(uv.x * 8.0f),
                              static_cast<std::uint32_t>(uv.y * 16.0f)};
        const glm::vec2 local = glm::fract(uv * glm::vec2{8.0f, 16.0f});
        const float edge =
            std::min(std::min(local.x, 1.0f - local.x) * 2.0f, std::min(local.y, 1.0f - local.y));
        const float joint = 1.0f - glm::smoothstep(0.03f, 0.09f, edge);
        const float tone = lattice_unit(tile.x, tile.y, seed);
        const float dirt = fractal_noise(uv, {4, 4}, 5, seed + 1);
        const glm::vec3 clay = glm::mix(glm::vec3{0.60f, 0.40f, 0.31f}, glm::vec3{0.70f, 0.49f, 0.38f}, tone);
        return Texel{{clay * (0.85f + 0.35f * (dirt - 0.5f)) * (1.0f - 0.3f * joint), 1.0f}, 0.0f, 0.9f};
    });
    return {"roof-tiles", canvas.colour_image("roof-tiles"), {}, {}, {}};
}

PaintedSet paint_road_paint(std::uint32_t seed) {
    // Worn in places down to the asphalt: the alpha mask is high where paint is left.
    Canvas canvas{256, 256};
    canvas.paint([&](glm::vec2 uv) {
        const float wear = fractal_noise(uv, {8, 8}, 5, seed);
        const float grain = fractal_noise(uv, {90, 90}, 2, seed + 7);
        const float left = 0.75f - 1.6f * (wear - 0.52f) - 0.7f * (grain - 0.5f);
        const float value = 0.86f + 0.10f * (grain - 0.5f) - 0.12f * (wear - 0.4f);
        return Texel{{value, value, value * 0.97f, left}, 0.0f, 0.7f};
    });
    return {"road-paint", canvas.colour_image("road-paint"), {}, {}, {}};
}

PaintedSet paint_cover(std::uint32_t seed) {
    // Cast iron with rows of raised lozenges inside a rim.
    Canvas canvas{128, 128};
    canvas.paint([&](glm::vec2 uv) {
        const glm::vec2 local = glm::abs(glm::fract(uv * 10.0f) - 0.5f);
        const float lozenge = 1.0f - glm::smoothstep(0.26f, 0.36f, local.x + local.y);
        const float rim = glm::smoothstep(0.44f, 0.46f, glm::length(uv - 0.5f));
        const float raised = std::max(lozenge, rim);
        const float rust = fractal_noise(uv, {6, 6}, 4, seed);
        const float value = 0.26f + 0.14f * raised + 0.10f * (rust - 0.5f);
        return Texel{{value * (1.0f + 0.10f * rust), value, value * 0.95f, 1.0f}, 0.004f * raised, 0.55f};
    });
    return {"cover", canvas.colour_image("cover"), canvas.normal_image("cover-normal", 0.7f), {}, {}};
}

}  // namespace rambla::assets::generate
