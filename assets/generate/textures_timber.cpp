#include <algorithm>
#include <cmath>

#include "assets/generate/canvas.h"
#include "assets/generate/noise.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

PaintedSet paint_louvre(std::uint32_t seed) {
    // One leaf of a shutter, 1 m of it: slats every 5 cm between stiles; painted wood, coloured by the
    // material.
    Canvas canvas{128, 256};
    canvas.paint([&](glm::vec2 uv) {
        constexpr float k_slats = 20.0f;
        const float phase = glm::fract(uv.y * k_slats);
        const float edge = std::min(uv.x, 1.0f - uv.x);
        const bool stile = edge < 0.10f;
        const float grain = fractal_noise(uv, {40, 4}, 3, seed);
        const float slat_tone =
            lattice_unit(static_cast<std::uint32_t>(uv.y * k_slats), stile ? 1 : 0, seed + 4);
        float value = 0.86f + 0.10f * (grain - 0.5f) + 0.06f * (slat_tone - 0.5f);
        float height = 0.0f;
        if (stile) {
            height = 0.012f;
        } else {
            value *= glm::mix(0.42f, 1.0f,
                              glm::smoothstep(0.05f, 0.45f, phase));  // below the slat above it is dark
            height = 0.010f * phase;  // slats lean outwards, so that rain runs off
        }
        return Texel{{value, value, value, 1.0f}, height, 0.6f};
    });
    return {"louvre", canvas.colour_image("louvre"), canvas.normal_image("louvre-normal", 0.6f), {}, {}};
}

PaintedSet paint_timber(std::uint32_t seed) {
    Canvas canvas{256, 256};
    canvas.paint([&](glm::vec2 uv) {
        const float warp = fractal_noise(uv, {4, 2}, 3, seed);
        const float rings = value_noise({uv.x, glm::fract(uv.y + 0.05f * warp)}, {4, 48}, seed + 3);
        const float fine = fractal_noise(uv, {8, 128}, 2, seed + 5);
        const float board = glm::fract(uv.y * 8.0f);
        const float joint = 1.0f - glm::smoothstep(0.02f, 0.07f, std::min(board, 1.0f - board));
        const float value = (0.82f + 0.16f * (rings - 0.5f) + 0.14f * (fine - 0.5f)) * (1.0f - 0.5f * joint);
        return Texel{{value, value * 0.97f, value * 0.92f, 1.0f}, 0.0f, 0.65f};
    });
    return {"timber", canvas.colour_image("timber"), {}, {}, {}};
}

PaintedSet paint_door(std::uint32_t seed) {
    // Two leaves, each with a square panel, a tall one and a round-edged one; the picture spans the whole
    // door.
    Canvas canvas{256, 512};
    canvas.paint([&](glm::vec2 uv) {
        const float leaf = glm::fract(uv.x * 2.0f);
        const auto panel = [&](float top, float bottom) {
            const float dx = std::min(leaf - 0.16f, 0.84f - leaf) * 0.6f;
            const float dy = std::min(uv.y - top, bottom - uv.y) * 2.6f;
            return std::min(dx, dy);  // metres inside the panel's edge
        };
        const float inside = std::max({panel(0.05f, 0.20f), panel(0.25f, 0.62f), panel(0.67f, 0.95f)});
        const float groove = 1.0f - glm::smoothstep(0.006f, 0.022f, std::abs(inside));
        const float field = glm::smoothstep(0.02f, 0.05f, inside);
        const float split = 1.0f - glm::smoothstep(0.004f, 0.012f, std::abs(uv.x - 0.5f) * 1.2f);
        const float grain = fractal_noise(uv, {60, 6}, 3, seed);
        const float dirt = glm::smoothstep(0.90f, 1.0f, uv.y);
        const float value = (0.84f + 0.14f * (grain - 0.5f) + 0.03f * field) *
                            (1.0f - 0.45f * std::max(groove, split)) * (1.0f - 0.25f * dirt);
        return Texel{{value, value, value, 1.0f}, 0.012f * field - 0.010f * std::max(groove, split), 0.5f};
    });
    return {"door", canvas.colour_image("door"), canvas.normal_image("door-normal", 1.3f), {}, {}};
}

PaintedSet paint_bark(std::uint32_t seed) {
    // Plane trees shed plates: pale cream and olive islands on grey-brown.
    Canvas canvas{256, 256};
    canvas.paint([&](glm::vec2 uv) {
        const float warp = fractal_noise(uv, {5, 5}, 3, seed);
        const glm::vec2 plates = cell_noise(glm::fract(uv + 0.08f * (warp - 0.5f)), {4, 3}, seed + 1);
        const float kind = fractal_noise(uv, {4, 3}, 3, seed + 2);
        const float grain = fractal_noise(uv, {24, 12}, 4, seed + 3);
        const float edge = glm::smoothstep(0.0f, 0.05f, plates.y - plates.x);
        glm::vec3 colour = glm::mix(glm::vec3{0.44f, 0.41f, 0.34f}, glm::vec3{0.66f, 0.63f, 0.51f},
                                    glm::smoothstep(0.42f, 0.60f, kind));
        colour = glm::mix(colour, glm::vec3{0.50f, 0.52f, 0.38f}, glm::smoothstep(0.55f, 0.70f, warp));
        colour *= (0.92f + 0.35f * (grain - 0.5f)) * glm::mix(0.86f, 1.0f, edge);
        return Texel{{colour, 1.0f}, 0.004f * edge + 0.008f * grain, 0.9f};
    });
    return {"bark", canvas.colour_image("bark"), canvas.normal_image("bark-normal", 1.0f), {}, {}};
}

PaintedSet paint_fabric(std::uint32_t seed) {
    // Awning canvas: stripes of 20 cm, white and the material's colour in one: dark stripes carry the hue's
    // depth.
    Canvas canvas{256, 256};
    canvas.paint([&](glm::vec2 uv) {
        const float phase = glm::fract(uv.x * 4.0f);
        const float stripe = glm::smoothstep(0.23f, 0.25f, phase) - glm::smoothstep(0.73f, 0.75f, phase);
        const float weave = lattice_unit(static_cast<std::uint32_t>(uv.x * 256.0f),
                                         static_cast<std::uint32_t>(uv.y * 256.0f), seed);
        const float dirt = fractal_noise(uv, {4, 4}, 4, seed + 2);
        const float shade = 1.0f + 0.06f * (weave - 0.5f) + 0.16f * (dirt - 0.5f);
        const glm::vec3 colour =
            glm::mix(glm::vec3{0.92f, 0.90f, 0.84f}, glm::vec3{0.62f, 0.20f, 0.16f}, stripe);
        return Texel{{colour * shade, 1.0f}, 0.0f, 0.9f};
    });
    return {"fabric", canvas.colour_image("fabric"), {}, {}, {}};
}

PaintedSet paint_cloth(std::uint32_t seed) {
    // Twill, 25 cm of it; coloured by the vertices.
    Canvas canvas{128, 128};
    canvas.paint([&](glm::vec2 uv) {
        const float twill = std::abs(glm::fract((uv.x + uv.y) * 32.0f) - 0.5f) * 2.0f;
        const float fold = fractal_noise(uv, {3, 3}, 4, seed);
        const float value = 0.90f + 0.08f * (twill - 0.5f) + 0.18f * (fold - 0.5f);
        return Texel{{value, value, value, 1.0f}, 0.0006f * twill + 0.012f * fold, 0.85f};
    });
    return {"cloth", canvas.colour_image("cloth"), canvas.normal_image("cloth-normal", 0.25f), {}, {}};
}

}  // namespace rambla::assets::generate
