#include <algorithm>
#include <cmath>

#include "assets/generate/canvas.h"
#include "assets/generate/noise.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

constexpr float k_wall_m = 2.0f;  // as metres_per_repeat of walls

/// Where a point lies in a running bond of `columns` × `rows` stones: which one, and how far from its edges.
struct Bond {
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    float to_joint_m = 0.0f;
};

Bond bond_at(glm::vec2 uv, std::uint32_t columns, std::uint32_t rows) {
    const float y = uv.y * static_cast<float>(rows);
    const auto row = static_cast<std::uint32_t>(y);
    const float x = uv.x * static_cast<float>(columns) + ((row & 1u) ? 0.5f : 0.0f);
    const auto column = static_cast<std::uint32_t>(x);
    const float fx = x - static_cast<float>(column);
    const float fy = y - static_cast<float>(row);
    const float edge_x = std::min(fx, 1.0f - fx) * k_wall_m / static_cast<float>(columns);
    const float edge_y = std::min(fy, 1.0f - fy) * k_wall_m / static_cast<float>(rows);
    return {column % columns, row, std::min(edge_x, edge_y)};
}

}  // namespace

PaintedSet paint_plaster(std::uint32_t seed) {
    Canvas canvas{512, 512};
    canvas.paint([&](glm::vec2 uv) {
        const float stain = fractal_noise(uv, {3, 2}, 4, seed);
        const float streak =
            fractal_noise(uv, {24, 2}, 3, seed + 10);  // rain runs down: thin across, long down
        const float grain = fractal_noise(uv, {64, 64}, 3, seed + 20);
        const float patch = glm::smoothstep(0.60f, 0.68f, fractal_noise(uv, {4, 4}, 4, seed + 30));
        const float value = 0.90f + 0.10f * (stain - 0.5f) + 0.06f * (streak - 0.5f) +
                            0.06f * (grain - 0.5f) - 0.035f * patch;
        const float warmth = 0.02f * (stain - 0.5f);
        return Texel{
            {value + warmth, value, value - 1.5f * warmth, 1.0f}, 0.004f * grain + 0.0015f * patch, 0.9f};
    });
    return {
        "plaster", canvas.colour_image("plaster"), canvas.normal_image("plaster-normal", k_wall_m), {}, {}};
}

PaintedSet paint_brick(std::uint32_t seed) {
    constexpr std::uint32_t k_columns = 8;  // 25 cm with the joint
    constexpr std::uint32_t k_rows = 32;    // 6.25 cm with the joint
    Canvas canvas{512, 512};
    canvas.paint([&](glm::vec2 uv) {
        const Bond bond = bond_at(uv, k_columns, k_rows);
        const float tone = lattice_unit(bond.column, bond.row, seed);
        const float burnt = lattice_unit(bond.column, bond.row, seed + 1);
        const float grain = fractal_noise(uv, {96, 96}, 2, seed + 2);
        const float stain = fractal_noise(uv, {3, 3}, 4, seed + 3);
        const float stone = glm::smoothstep(0.004f, 0.009f, bond.to_joint_m + 0.003f * (grain - 0.5f));
        glm::vec3 clay = glm::mix(glm::vec3{0.62f, 0.36f, 0.27f}, glm::vec3{0.74f, 0.47f, 0.34f}, tone);
        if (burnt > 0.88f) clay *= 0.80f;
        const glm::vec3 mortar{0.70f, 0.66f, 0.60f};
        const float shade = 0.92f + 0.16f * (grain - 0.5f) + 0.14f * (stain - 0.5f);
        return Texel{{glm::mix(mortar, clay, stone) * shade, 1.0f}, 0.006f * stone + 0.002f * grain, 0.9f};
    });
    return {
        "brick", canvas.colour_image("brick"),           canvas.normal_image("brick-normal", k_wall_m), {},
        {},      canvas.relief("brick-height", k_wall_m)};
}

PaintedSet paint_stone(std::uint32_t seed) {
    constexpr std::uint32_t k_columns = 3;
    constexpr std::uint32_t k_rows = 5;  // ashlar of 67 × 40 cm
    Canvas canvas{512, 512};
    canvas.paint([&](glm::vec2 uv) {
        const Bond bond = bond_at(uv, k_columns, k_rows);
        const float tone = lattice_unit(bond.column, bond.row, seed);
        const float grain = fractal_noise(uv, {80, 80}, 3, seed + 2);
        const float cloud = fractal_noise(uv, {5, 5}, 5, seed + 3);
        const float block = glm::smoothstep(0.004f, 0.016f, bond.to_joint_m);
        const float value = (0.80f + 0.07f * tone + 0.12f * (cloud - 0.5f) + 0.09f * (grain - 0.5f)) *
                            glm::mix(0.72f, 1.0f, block);
        return Texel{{value, value * 0.955f, value * 0.87f, 1.0f}, 0.010f * block + 0.004f * grain, 0.85f};
    });
    return {
        "stone", canvas.colour_image("stone"),           canvas.normal_image("stone-normal", k_wall_m), {},
        {},      canvas.relief("stone-height", k_wall_m)};
}

PaintedSet paint_stucco(std::uint32_t seed) {
    Canvas canvas{256, 256};
    canvas.paint([&](glm::vec2 uv) {
        const float grain = fractal_noise(uv, {48, 48}, 3, seed);
        const float stain = fractal_noise(uv, {4, 3}, 4, seed + 9);
        const float value = 0.88f + 0.07f * (grain - 0.5f) + 0.12f * (stain - 0.5f);
        return Texel{{value, value * 0.985f, value * 0.95f, 1.0f}, 0.0f, 0.85f};
    });
    return {"stucco", canvas.colour_image("stucco"), {}, {}, {}};
}

}  // namespace rambla::assets::generate
