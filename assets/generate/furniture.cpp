#include "assets/generate/furniture.h"

#include <array>

namespace rambla::assets::generate {

namespace {

Ring round_ring(float y, float radius, float x = 0.0f, float z = 0.0f) {
    return {{x, y, z}, {radius, 0.0f, 0.0f}, {0.0f, 0.0f, radius}};
}

/// A four-sided glass body, wider above, with iron edges, base and hat; its foot is at `foot`.
void build_lantern(Builder& b, glm::vec3 foot) {
    constexpr float k_low = 0.10f;
    constexpr float k_high = 0.17f;
    constexpr float k_tall = 0.40f;
    const std::array<glm::vec2, 4> around{{{1.0f, 1.0f}, {1.0f, -1.0f}, {-1.0f, -1.0f}, {-1.0f, 1.0f}}};
    b.box(Surface::iron, foot + glm::vec3{-0.12f, -0.05f, -0.12f}, foot + glm::vec3{0.12f, 0.0f, 0.12f});
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec2 p = around[i];
        const glm::vec2 q = around[(i + 1) % 4];
        const auto at = [&](glm::vec2 c, float r, float y) {
            return foot + glm::vec3{c.x * r, y, c.y * r};
        };
        b.face(Surface::street_lantern, at(p, k_low, 0.0f), at(q, k_low, 0.0f), at(q, k_high, k_tall),
               at(p, k_high, k_tall));
        b.face(Surface::iron, at(p, 0.20f, k_tall), at(q, 0.20f, k_tall), at(q, 0.06f, k_tall + 0.16f),
               at(p, 0.06f, k_tall + 0.16f));
        b.face(Surface::iron, at(q, 0.20f, k_tall), at(p, 0.20f, k_tall), at(p, k_high - 0.03f, k_tall),
               at(q, k_high - 0.03f, k_tall));
        const glm::vec3 edge_low = at(p, k_low + 0.01f, 0.0f);
        const glm::vec3 edge_high = at(p, k_high + 0.01f, k_tall);
        const std::array<Ring, 2> edge{{{edge_low, {0.012f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.012f}},
                                        {edge_high, {0.012f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.012f}}}};
        b.tube(Surface::iron, edge, 4, false, false);
    }
    const std::array<Ring, 3> knob{
        {{foot + glm::vec3{0.0f, k_tall + 0.15f, 0.0f}, {0.05f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.05f}},
         {foot + glm::vec3{0.0f, k_tall + 0.21f, 0.0f}, {0.035f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.035f}},
         {foot + glm::vec3{0.0f, k_tall + 0.27f, 0.0f}, {0.004f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.004f}}}};
    b.tube(Surface::iron, knob, 6, false, true);
}

}  // namespace

void build_lamp_post(Builder& b) {
    const std::array<Ring, 12> post{
        round_ring(0.0f, 0.19f),   round_ring(0.10f, 0.19f),  round_ring(0.16f, 0.15f),
        round_ring(0.55f, 0.12f),  round_ring(0.62f, 0.15f),  round_ring(0.70f, 0.09f),
        round_ring(1.05f, 0.075f), round_ring(1.10f, 0.095f), round_ring(1.15f, 0.065f),
        round_ring(3.20f, 0.045f), round_ring(3.26f, 0.080f), round_ring(3.34f, 0.040f)};
    b.tube(Surface::iron, post, 10, false, true);
    const std::array<Ring, 2> arm{{{{-0.28f, 3.08f, 0.0f}, {0.0f, 0.018f, 0.0f}, {0.0f, 0.0f, 0.018f}},
                                   {{0.28f, 3.08f, 0.0f}, {0.0f, 0.018f, 0.0f}, {0.0f, 0.0f, 0.018f}}}};
    b.tube(Surface::iron, arm, 6, true, true);
    build_lantern(b, {0.0f, k_lamp_height_m - 0.36f, 0.0f});
}

void build_bench(Builder& b) {
    for (const float x : {-0.62f, 0.62f}) {
        b.box(Surface::iron, {x - 0.03f, 0.0f, 0.14f}, {x + 0.03f, 0.42f, 0.19f});
        b.box(Surface::iron, {x - 0.03f, 0.0f, -0.22f}, {x + 0.03f, 0.84f, -0.17f});
        b.box(Surface::iron, {x - 0.03f, 0.37f, -0.17f}, {x + 0.03f, 0.42f, 0.14f});
        b.box(Surface::iron, {x - 0.025f, 0.62f, -0.17f}, {x + 0.025f, 0.66f, 0.17f});
    }
    for (int i = 0; i < 4; ++i) {
        const float z = -0.15f + 0.10f * static_cast<float>(i);
        b.box(Surface::timber, {-0.8f, 0.42f, z}, {0.8f, 0.455f, z + 0.08f});
    }
    for (int i = 0; i < 3; ++i) {
        const float y = 0.53f + 0.11f * static_cast<float>(i);
        b.box(Surface::timber, {-0.8f, y, -0.165f}, {0.8f, y + 0.085f, -0.135f});
    }
}

void build_bollard(Builder& b) {
    const std::array<Ring, 7> post{round_ring(0.0f, 0.085f),  round_ring(0.06f, 0.085f),
                                   round_ring(0.10f, 0.06f),  round_ring(0.72f, 0.055f),
                                   round_ring(0.75f, 0.075f), round_ring(0.80f, 0.07f),
                                   round_ring(0.88f, 0.02f)};
    b.tube(Surface::iron, post, 8, false, true);
}

void build_litter_bin(Builder& b) {
    b.box(Surface::iron, {-0.28f, 0.0f, -0.02f}, {-0.24f, 0.95f, 0.02f});
    b.box(Surface::iron, {0.24f, 0.0f, -0.02f}, {0.28f, 0.95f, 0.02f});
    b.colour = {0.75f, 0.80f, 0.78f, 1.0f};
    const std::array<Ring, 5> bin{round_ring(0.24f, 0.17f), round_ring(0.28f, 0.20f),
                                  round_ring(0.82f, 0.23f), round_ring(0.84f, 0.24f),
                                  round_ring(0.86f, 0.20f)};
    b.tube(Surface::metal, bin, 12, true, true);
    b.colour = glm::vec4{1.0f};
}

void build_tree_pit(Builder& b) {
    constexpr float k_half = 0.45f;
    constexpr float k_frame = 0.09f;
    b.box(Surface::soil, {-k_half, -0.02f, -k_half}, {k_half, 0.022f, k_half}, k_side_top);
    for (const float side : {-1.0f, 1.0f}) {
        const float outer = side * k_half;
        const float inner = side * (k_half - k_frame);
        b.box(Surface::kerb, {std::min(outer, inner), -0.02f, -k_half},
              {std::max(outer, inner), 0.045f, k_half}, k_all_sides & ~k_side_bottom);
        b.box(Surface::kerb, {-k_half + k_frame, -0.02f, std::min(outer, inner)},
              {k_half - k_frame, 0.045f, std::max(outer, inner)}, k_all_sides & ~k_side_bottom);
    }
}

void build_wall_lantern(Builder& b) {
    b.box(Surface::iron, {-0.06f, -0.16f, 0.0f}, {0.06f, 0.16f, 0.03f}, k_all_sides & ~k_side_back);
    b.box(Surface::iron, {-0.015f, -0.02f, 0.03f}, {0.015f, 0.015f, 0.52f});
    const std::array<Ring, 2> stay{{{{0.0f, -0.14f, 0.02f}, {0.012f, 0.0f, 0.0f}, {0.0f, 0.008f, 0.008f}},
                                    {{0.0f, -0.02f, 0.36f}, {0.012f, 0.0f, 0.0f}, {0.0f, 0.008f, 0.008f}}}};
    b.tube(Surface::iron, stay, 5, false, false);
    build_lantern(b, {0.0f, 0.06f, 0.50f});
}

}  // namespace rambla::assets::generate
