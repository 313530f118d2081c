#include "assets/generate/ground.h"

#include <cmath>

#include "assets/generate/building.h"

namespace rambla::assets::generate {

namespace {

constexpr float k_kerb_width_m = 0.20f;
constexpr float k_paint_lift_m = 0.02f;

glm::vec3 lifted(glm::vec2 p, float y) {
    return {p.x, y, p.y};
}

/// Flat ring between two outlines of equal corner count, facing up; outer is counter-clockwise from above.
void build_ring(Builder& b, Surface surface, const std::array<glm::vec2, 8>& inner,
                const std::array<glm::vec2, 8>& outer, float y) {
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t j = (i + 1) % 8;
        b.face(surface, lifted(outer[i], y), lifted(outer[j], y), lifted(inner[j], y), lifted(inner[i], y));
    }
}

/// Vertical ring facing outwards.
void build_step(Builder& b, Surface surface, const std::array<glm::vec2, 8>& outline, float y0, float y1) {
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t j = (i + 1) % 8;
        b.face(surface, lifted(outline[i], y0), lifted(outline[j], y0), lifted(outline[j], y1),
               lifted(outline[i], y1));
    }
}

}  // namespace

std::array<glm::vec2, 8> block_outline(const StreetPlan& plan, float offset) {
    // A corner moves along its side by offset · tan(22.5°), so that chamfers keep their 45°.
    const float side = 0.5f * plan.block_m + offset;
    const float end = 0.5f * plan.block_m - k_chamfer_m + 0.41421356f * offset;
    return {{{side, end},
             {side, -end},
             {end, -side},
             {-end, -side},
             {-side, -end},
             {-side, end},
             {-end, side},
             {end, side}}};
}

void build_block_ground(Builder& b, const StreetPlan& plan) {
    const float pavement = plan.pavement_m();
    const auto facade = block_outline(plan, -0.1f);  // under the walls, so that no gap shows at their foot
    const auto kerb_inner = block_outline(plan, pavement - k_kerb_width_m);
    const auto kerb = block_outline(plan, pavement);
    const auto gutter = block_outline(plan, pavement + k_gutter_m);
    build_ring(b, Surface::paving, facade, kerb_inner, k_kerb_height_m);
    build_ring(b, Surface::kerb, kerb_inner, kerb, k_kerb_height_m);
    build_step(b, Surface::kerb, kerb, -0.02f, k_kerb_height_m);
    build_ring(b, Surface::gutter, kerb, gutter, 0.0f);

    // The cell's square about the gutter: each corner of the square is met by both ends of a chamfer, so
    // sides are quadrilaterals and the corners are triangles.
    const float half = 0.5f * plan.pitch_m();
    // A whole number of repeats from cell to cell: no seam along the middle of a street.
    const float repeat = metres_per_repeat(Surface::asphalt);
    b.stretch = plan.pitch_m() / (repeat * std::round(plan.pitch_m() / repeat));
    const std::array<glm::vec2, 4> square{{{half, -half}, {-half, -half}, {-half, half}, {half, half}}};
    for (std::size_t side = 0; side < 4; ++side) {
        const glm::vec2 a = gutter[2 * side];
        const glm::vec2 c = gutter[2 * side + 1];
        const glm::vec2 from = square[(side + 3) % 4];
        const glm::vec2 to = square[side];
        const glm::vec2 next = gutter[(2 * side + 2) % 8];
        const std::array<glm::vec3, 4> road{lifted(from, 0.0f), lifted(to, 0.0f), lifted(c, 0.0f),
                                            lifted(a, 0.0f)};
        b.polygon(Surface::asphalt, road);
        const std::array<glm::vec3, 3> corner{lifted(to, 0.0f), lifted(next, 0.0f), lifted(c, 0.0f)};
        b.polygon(Surface::asphalt, corner);
    }
    b.stretch = 1.0f;
    const float yard = 0.5f * plan.block_m - k_house_depth_m + 0.5f;
    b.face(Surface::roof, {-yard, k_kerb_height_m, yard}, {yard, k_kerb_height_m, yard},
           {yard, k_kerb_height_m, -yard}, {-yard, k_kerb_height_m, -yard});
}

void build_edge_ground(Builder& b, const StreetPlan& plan, float length) {
    const float pavement = plan.pavement_m();
    const auto strip = [&](Surface surface, float x1, float z0, float z1, float y) {
        b.face(surface, {pavement, y, z1}, {x1, y, z1}, {x1, y, z0}, {pavement, y, z0});
    };
    strip(Surface::paving, length, -0.1f, pavement - k_kerb_width_m, k_kerb_height_m);
    strip(Surface::kerb, length, pavement - k_kerb_width_m, pavement, k_kerb_height_m);
    b.face(Surface::kerb, {pavement, -0.02f, pavement}, {length, -0.02f, pavement},
           {length, k_kerb_height_m, pavement}, {pavement, k_kerb_height_m, pavement});
    const float road_end = length - 0.5f * plan.street_width_m;
    strip(Surface::gutter, road_end, pavement, pavement + k_gutter_m, 0.0f);
    strip(Surface::asphalt, road_end, pavement + k_gutter_m, 0.5f * plan.street_width_m, 0.0f);
}

void build_crossing(Builder& b, const StreetPlan& plan) {
    constexpr float k_bar_m = 0.5f;
    constexpr float k_length_m = 3.0f;
    const float width = plan.carriageway_m() - 2.0f * k_gutter_m;
    const int bars = static_cast<int>((width + k_bar_m) / (2.0f * k_bar_m));
    const float used = static_cast<float>(2 * bars - 1) * k_bar_m;
    for (int i = 0; i < bars; ++i) {
        const float x = -0.5f * used + static_cast<float>(2 * i) * k_bar_m;
        const float z = 0.5f * k_length_m;
        b.face(Surface::paint, {x, k_paint_lift_m, z}, {x + k_bar_m, k_paint_lift_m, z},
               {x + k_bar_m, k_paint_lift_m, -z}, {x, k_paint_lift_m, -z});
    }
}

void build_manhole(Builder& b) {
    constexpr float k_radius_m = 0.32f;
    constexpr int k_sides = 16;
    std::array<glm::vec3, 4> ring{};
    for (int i = 0; i < k_sides; i += 2) {
        // Quadrilateral wedges about the centre keep the picture's coordinates simple.
        const auto at = [&](int k) {
            const float angle = 6.2831853f * static_cast<float>(k) / static_cast<float>(k_sides);
            return glm::vec3{k_radius_m * std::cos(angle), k_paint_lift_m, -k_radius_m * std::sin(angle)};
        };
        ring = {glm::vec3{0.0f, k_paint_lift_m, 0.0f}, at(i), at(i + 1), at(i + 2)};
        b.polygon(Surface::cover, ring);
    }
}

void build_drain(Builder& b) {
    b.picture(Surface::cover, {-0.35f, k_paint_lift_m, 0.13f}, {0.35f, k_paint_lift_m, 0.13f},
              {0.35f, k_paint_lift_m, -0.13f}, {-0.35f, k_paint_lift_m, -0.13f}, {0.2f, 0.7f}, {0.8f, 0.4f});
}

}  // namespace rambla::assets::generate
