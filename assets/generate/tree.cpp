#include "assets/generate/tree.h"

#include <array>
#include <cmath>

#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

constexpr float k_two_pi = 6.2831853f;

/// A bough from a to b, tapering, with a slight bend upwards.
void build_bough(Builder& b, glm::vec3 from, glm::vec3 to, float radius_from, float radius_to, int sides) {
    const glm::vec3 axis = glm::normalize(to - from);
    const glm::vec3 a = glm::normalize(glm::cross(
        std::abs(axis.y) < 0.9f ? glm::vec3{0.0f, 1.0f, 0.0f} : glm::vec3{1.0f, 0.0f, 0.0f}, axis));
    const glm::vec3 c = glm::cross(axis, a);
    const glm::vec3 middle = 0.5f * (from + to) - glm::vec3{0.0f, 0.08f * glm::length(to - from), 0.0f};
    const float radius = 0.5f * (radius_from + radius_to);
    const std::array<Ring, 3> rings{{{from, a * radius_from, c * radius_from},
                                     {middle, a * radius, c * radius},
                                     {to, a * radius_to, c * radius_to}}};
    b.tube(Surface::bark, rings, sides, false, false);
}

glm::vec3 on_sphere(Draws& draws) {
    const float y = draws.between(-1.0f, 1.0f);
    const float turn = k_two_pi * draws.unit();
    const float r = std::sqrt(std::max(0.0f, 1.0f - y * y));
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

void build_card(Builder& b, glm::vec3 centre, glm::vec3 facing, glm::vec3 crown_centre, glm::vec3 crown_half,
                float size, Draws& draws) {
    const glm::vec3 helper =
        std::abs(facing.y) < 0.9f ? glm::vec3{0.0f, 1.0f, 0.0f} : glm::vec3{1.0f, 0.0f, 0.0f};
    const glm::vec3 side = glm::normalize(glm::cross(helper, facing));
    const glm::vec3 up = glm::cross(facing, side);
    const float turn = k_two_pi * draws.unit();
    const glm::vec3 u = size * (side * std::cos(turn) + up * std::sin(turn));
    const glm::vec3 v = glm::cross(facing, u);
    const std::array<glm::vec3, 4> corners{centre - u - v, centre + u - v, centre + u + v, centre - u + v};
    std::array<glm::vec3, 4> normals;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3 outwards =
            glm::normalize((corners[i] - crown_centre) / crown_half + glm::vec3{0.0f, 0.25f, 0.0f});
        normals[i] = glm::normalize(outwards + 0.35f * facing);
    }
    const float cell = 1.0f / static_cast<float>(k_leaf_cells);
    const float left = static_cast<float>(draws.below(k_leaf_cells)) * cell;
    b.card(Surface::foliage, corners, normals, {left + 0.004f, 1.0f}, {left + cell - 0.004f, 0.0f});
}

}  // namespace

void build_tree(Builder& b, Draws& draws) {
    const float fork = draws.between(2.6f, 3.0f);
    const float radius = draws.between(0.13f, 0.17f);
    const float lean_x = draws.between(-0.08f, 0.08f);
    const float lean_z = draws.between(-0.08f, 0.08f);
    const auto ring = [&](float y, float r) {
        const float share = y / fork;
        return Ring{{lean_x * share * share, y, lean_z * share * share}, {r, 0.0f, 0.0f}, {0.0f, 0.0f, r}};
    };
    const std::array<Ring, 5> trunk{ring(-0.1f, 1.7f * radius), ring(0.12f, 1.3f * radius),
                                    ring(0.6f, 1.05f * radius), ring(0.6f * fork, 0.92f * radius),
                                    ring(fork + 0.05f, 0.85f * radius)};
    b.tube(Surface::bark, trunk, 9, false, true);

    const glm::vec3 crown{lean_x, fork + 2.2f, lean_z};
    const glm::vec3 half{draws.between(1.65f, 1.9f), draws.between(2.1f, 2.5f), draws.between(1.65f, 1.9f)};
    const glm::vec3 top{lean_x, fork, lean_z};
    constexpr int k_boughs = 6;
    for (int i = 0; i < k_boughs; ++i) {
        const float turn =
            k_two_pi * (static_cast<float>(i) + draws.between(-0.3f, 0.3f)) / static_cast<float>(k_boughs);
        const float rise = draws.between(1.3f, 2.8f);
        const glm::vec3 tip = top + glm::vec3{1.15f * std::cos(turn), rise, 1.15f * std::sin(turn)};
        build_bough(b, top - glm::vec3{0.0f, 0.15f, 0.0f}, tip, 0.5f * radius, 0.035f, 6);
        const glm::vec3 twig = 0.5f * (top + tip);
        build_bough(b, twig,
                    twig + glm::vec3{0.9f * std::cos(turn + 0.8f), 0.9f, 0.9f * std::sin(turn + 0.8f)},
                    0.035f, 0.012f, 4);
    }
    // Clumps of leaves near the crown's surface with gaps between them, as plane trees grow after pollarding.
    constexpr int k_clumps = 34;
    constexpr int k_cards = 15;
    for (int i = 0; i < k_clumps; ++i) {
        const float depth = draws.between(0.45f, 0.92f);
        glm::vec3 direction = on_sphere(draws);
        direction.y = std::max(direction.y, -0.72f);  // flat below: light and traffic keep it so
        const glm::vec3 clump = crown + half * direction * depth;
        for (int k = 0; k < k_cards; ++k) {
            const glm::vec3 offset = on_sphere(draws) * draws.between(0.1f, 0.62f);
            const glm::vec3 centre = clump + offset;
            const glm::vec3 outwards = glm::normalize((centre - crown) / half);
            const glm::vec3 facing = glm::normalize(outwards + 0.9f * on_sphere(draws));
            const float shade =
                glm::mix(0.70f, 1.0f, glm::clamp(glm::length((centre - crown) / half), 0.0f, 1.0f));
            b.colour = {shade, shade, shade, 1.0f};
            build_card(b, centre, facing, crown, half, draws.between(0.26f, 0.38f), draws);
        }
    }
    b.colour = glm::vec4{1.0f};
}

}  // namespace rambla::assets::generate
