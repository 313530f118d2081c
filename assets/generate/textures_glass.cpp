#include <algorithm>
#include <cmath>

#include "assets/generate/canvas.h"
#include "assets/generate/noise.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

/// How much of a curtain or blind hangs at a place of a window: 0 none, 1 dense.
/// @param local  0 … 1 within the window, y downwards
float drapery(std::uint32_t cell, glm::vec2 local, std::uint32_t seed) {
    const float folds =
        0.75f + 0.25f * std::sin(local.x * 70.0f + 3.0f * value_noise(local, {5, 2}, seed + cell));
    switch (cell) {
        case 0:
            return 0.0f;
        case 1: {  // two curtains, drawn aside
            const float sway = 0.20f + 0.06f * local.y;
            return std::min(local.x, 1.0f - local.x) < sway ? folds : 0.0f;
        }
        case 2:
            return local.y < 0.46f ? 0.80f + 0.10f * std::sin(local.y * 240.0f) : 0.0f;  // blind half down
        default:
            return 0.62f * folds + 0.2f * value_noise(local, {40, 60}, seed);  // lace
    }
}

}  // namespace

PaintedSet paint_window(std::uint32_t seed) {
    Canvas canvas{512, 256};
    canvas.paint([&](glm::vec2 uv) {
        const auto cell = static_cast<std::uint32_t>(uv.x * k_window_cells);
        const glm::vec2 local{glm::fract(uv.x * k_window_cells), uv.y};
        const float room =
            0.13f + 0.06f * (1.0f - local.y) + 0.05f * (fractal_noise(uv, {16, 4}, 3, seed) - 0.5f);
        const glm::vec3 dark{room * 0.92f, room, room * 1.10f};
        const float cloth = drapery(cell, local, seed);
        return Texel{{glm::mix(dark, glm::vec3{0.52f, 0.52f, 0.48f}, 0.75f * cloth), 1.0f}, 0.0f, 0.05f};
    });
    return {"window", canvas.colour_image("window"), {}, {}, {}};
}

PaintedSet paint_window_lit(std::uint32_t seed) {
    Canvas colour{512, 256};
    Canvas glow{512, 256};
    glow.paint([&](glm::vec2 uv) {
        const auto cell = static_cast<std::uint32_t>(uv.x * k_window_cells);
        const glm::vec2 local{glm::fract(uv.x * k_window_cells), uv.y};
        const float lamp_x = 0.3f + 0.4f * lattice_unit(cell, 1, seed);
        const glm::vec2 to_lamp{local.x - lamp_x, (local.y - 0.18f) * 1.6f};
        const float falloff = 1.0f / (1.0f + 5.0f * glm::dot(to_lamp, to_lamp));
        const bool furniture = local.y > 0.72f && value_noise({local.x, 0.5f}, {6, 1}, seed + cell) > 0.45f;
        const float cloth = drapery(cell == 0 ? 3 : cell, local, seed);
        glm::vec3 warm = glm::vec3{0.98f, 0.78f, 0.48f} * std::sqrt(falloff);
        if (furniture) warm *= 0.45f;
        warm = glm::mix(warm, glm::vec3{0.92f, 0.70f, 0.44f} * std::sqrt(falloff), 0.7f * cloth) *
               (1.0f - 0.18f * cloth);
        return Texel{{warm, 1.0f}, 0.0f, 0.05f};
    });
    colour.paint([&](glm::vec2 uv) {
        const auto cell = static_cast<std::uint32_t>(uv.x * k_window_cells);
        const float cloth = drapery(cell == 0 ? 3 : cell, {glm::fract(uv.x * k_window_cells), uv.y}, seed);
        const float value = 0.20f + 0.28f * cloth;
        return Texel{{value, value * 0.95f, value * 0.85f, 1.0f}, 0.0f, 0.05f};
    });
    return {
        "window-lit", colour.colour_image("window-lit"), {}, {}, glow.colour_image("window-lit-emission")};
}

namespace {

/// What shelves of goods look like at a place of a shop window.
/// @param local  0 … 1 within the window, y downwards; sizes in goods across and shelves down
glm::vec3 shelves(glm::vec2 local, std::uint32_t across, std::uint32_t down, glm::vec3 wall, glm::vec3 goods,
                  float variety, std::uint32_t seed) {
    const auto shelf = static_cast<std::uint32_t>(local.y * static_cast<float>(down));
    const auto slot = static_cast<std::uint32_t>(local.x * static_cast<float>(across));
    const float above_board = 1.0f - glm::fract(local.y * static_cast<float>(down));
    const float beside = glm::fract(local.x * static_cast<float>(across));
    if (above_board < 0.08f) return 0.45f * wall;
    const float height = 0.30f + 0.50f * lattice_unit(slot, shelf, seed);
    const bool stands = lattice_unit(slot, shelf, seed + 9) > 0.16f && beside > 0.06f && beside < 0.94f;
    if (!stands || above_board > height) return wall;
    const glm::vec3 tint{lattice_unit(slot, shelf, seed + 1), lattice_unit(slot, shelf, seed + 2),
                         lattice_unit(slot, shelf, seed + 3)};
    const float round = 1.0f - 0.35f * std::abs(2.0f * beside - 1.0f);
    return glm::mix(goods, tint, variety) * round;
}

/// A dressed tailor's dummy about x = middle.
bool dummy(glm::vec2 local, float middle) {
    const float dx = std::abs(local.x - middle);
    const bool head = glm::length(glm::vec2{dx, (local.y - 0.30f) * 0.75f}) < 0.032f;
    const bool trunk = local.y > 0.36f && local.y < 0.62f && dx < 0.085f - 0.12f * std::abs(local.y - 0.44f);
    const bool skirt = local.y >= 0.60f && local.y < 0.88f && dx < 0.06f + 0.22f * (local.y - 0.60f);
    const bool stand = local.y >= 0.88f && local.y < 0.95f && dx < 0.008f;
    return head || trunk || skirt || stand;
}

glm::vec3 shop_interior(std::uint32_t cell, glm::vec2 local, std::uint32_t seed) {
    switch (cell) {
        case 0:
            return shelves(local, 26, 5, {0.56f, 0.46f, 0.34f}, {0.60f, 0.46f, 0.34f}, 0.30f, seed);  // books
        case 1: {  // bakery: loaves above a counter
            if (local.y > 0.66f)
                return glm::vec3{0.66f, 0.60f, 0.50f} * (0.75f + 0.25f * value_noise(local, {40, 6}, seed));
            return shelves({local.x, local.y / 0.66f}, 9, 3, {0.74f, 0.66f, 0.52f}, {0.62f, 0.40f, 0.20f},
                           0.08f, seed);
        }
        case 2: {  // clothes on dummies before a pale wall
            if (dummy(local, 0.27f)) return {0.52f, 0.20f, 0.19f};
            if (dummy(local, 0.68f)) return {0.22f, 0.30f, 0.44f};
            return glm::vec3{0.76f, 0.74f, 0.68f} * (local.y > 0.93f ? 0.5f : 1.0f);
        }
        default: {  // a bar: dark wood, bottles, pendant lamps
            if (local.y > 0.62f) return {0.26f, 0.18f, 0.12f};
            const float lamp =
                glm::length(glm::vec2{glm::fract(local.x * 3.0f) - 0.5f, (local.y - 0.22f) * 5.0f});
            if (lamp < 0.16f) return {1.0f, 0.88f, 0.62f};
            return shelves({local.x, local.y / 0.62f}, 30, 3, {0.36f, 0.28f, 0.20f}, {0.30f, 0.36f, 0.24f},
                           0.22f, seed) *
                   (0.7f + 0.5f / (1.0f + 8.0f * lamp));
        }
    }
}

}  // namespace

PaintedSet paint_shop(std::uint32_t seed) {
    Canvas colour{1024, 256};
    Canvas glow{1024, 256};
    const auto interior = [&](glm::vec2 uv) {
        const auto cell = static_cast<std::uint32_t>(uv.x * static_cast<float>(k_shop_cells));
        const glm::vec2 local{glm::fract(uv.x * static_cast<float>(k_shop_cells)), uv.y};
        const float lamps =
            0.55f + 0.45f / (1.0f + 6.0f * local.y) + 0.12f * std::cos(local.x * 18.8496f) * (1.0f - local.y);
        return shop_interior(cell, local, seed) * std::min(lamps, 1.0f);
    };
    glow.paint([&](glm::vec2 uv) { return Texel{{interior(uv), 1.0f}, 0.0f, 0.05f}; });
    colour.paint([&](glm::vec2 uv) { return Texel{{0.08f + 0.40f * interior(uv), 1.0f}, 0.0f, 0.05f}; });
    return {"shop", colour.colour_image("shop"), {}, {}, glow.colour_image("shop-emission")};
}

}  // namespace rambla::assets::generate
