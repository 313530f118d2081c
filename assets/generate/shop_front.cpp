#include <array>

#include "assets/generate/facade.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

/// Cell of the shop pattern that suits each sign: books or boxes, loaves, clothes, a bar.
constexpr std::array<std::uint32_t, k_sign_cells> k_goods{1, 0, 3, 0, 1, 3, 1, 2};

constexpr float k_riser_m = 0.48f;  ///< below the window
constexpr float k_bar_m = 0.07f;    ///< width of what stands, and of what lies across, a little more
constexpr float k_rail_m = 0.08f;
constexpr float k_transom_m = 0.55f;  ///< lower edge of the rail below the top lights, from the top
/// Heights of the boards of a door.
constexpr std::array<glm::vec2, 2> k_door_boards{{{0.02f, 0.32f}, {0.98f, 1.08f}}};

/// What frames leave free of the pane that fills an opening.
/// @param split  middle of the bar between door and window
/// @param u_min, u_max  across the opening; v runs from 0.99 at its foot to 0.01
std::vector<Glass> glass_of(const Opening& o, float split, bool door_left, float u_min, float u_max) {
    std::vector<Glass> glass;
    const auto uv = [&](glm::vec2 p) {
        const glm::vec2 share = (p - o.min) / (o.max - o.min);
        return glm::mix(glm::vec2{u_min, 0.99f}, glm::vec2{u_max, 0.01f}, share);
    };
    const auto add = [&](float x0, float x1, float y0, float y1) {
        glass.push_back({{{x0, y0}, {x1, y1}}, uv({x0, y0}), uv({x1, y1})});
    };
    const float transom = o.max.y - k_transom_m;
    for (const bool left : {true, false}) {
        const float x0 = left ? o.min.x + k_bar_m : split + 0.5f * k_bar_m;
        const float x1 = left ? split - 0.5f * k_bar_m : o.max.x - k_bar_m;
        if (left == door_left) {
            add(x0, x1, k_door_boards[0].y, k_door_boards[1].x);
            add(x0, x1, k_door_boards[1].y, transom);
        } else {
            add(x0, x1, k_riser_m, transom);
        }
        add(x0, x1, transom + k_rail_m, o.max.y - k_rail_m);
    }
    return glass;
}

void build_awning(Builder& b, const Opening& o) {
    constexpr float k_reach = 1.05f;
    const float high = o.max.y - 0.02f;
    const float low = high - 0.52f;
    const float x0 = o.min.x - 0.12f;
    const float x1 = o.max.x + 0.12f;
    b.face(Surface::awning, {x0, low, k_reach}, {x1, low, k_reach}, {x1, high, 0.06f}, {x0, high, 0.06f});
    b.face(Surface::awning, {x0, low - 0.20f, k_reach}, {x1, low - 0.20f, k_reach}, {x1, low, k_reach},
           {x0, low, k_reach});
    b.box(Surface::iron, {x0, low - 0.03f, k_reach - 0.05f}, {x1, low, k_reach - 0.02f});
    for (const float x : {x0 + 0.03f, x1 - 0.06f})
        b.face(Surface::iron, {x, low - 0.02f, k_reach - 0.04f}, {x + 0.03f, low - 0.02f, k_reach - 0.04f},
               {x + 0.03f, high - 0.45f, 0.0f}, {x, high - 0.45f, 0.0f});
    b.box(Surface::awning, {x0, high - 0.04f, 0.0f}, {x1, high + 0.10f, 0.10f}, k_all_sides & ~k_side_back);
}

void build_sign(Builder& b, const Opening& o, std::uint32_t cell) {
    const float bottom = o.max.y + 0.18f;
    const float top = bottom + 0.40f;
    const float centre = 0.5f * (o.min.x + o.max.x);
    const float half = std::min(1.5f, 0.5f * (o.max.x - o.min.x) + 0.1f);
    constexpr float k_out = 0.07f;
    const float row = 1.0f / static_cast<float>(k_sign_cells);
    const float v = static_cast<float>(cell) * row;
    // Narrow boards show the middle of the picture, in its own proportions.
    const float share = std::min(1.0f, 2.0f * half / 3.2f);
    b.picture(Surface::sign, {centre - half, bottom, k_out}, {centre + half, bottom, k_out},
              {centre + half, top, k_out}, {centre - half, top, k_out},
              {0.5f - 0.5f * share, v + 0.99f * row}, {0.5f + 0.5f * share, v + 0.01f * row});
    b.box(Surface::iron, {centre - half, bottom, 0.0f}, {centre + half, top, k_out},
          k_all_sides & ~(k_side_back | k_side_front));
}

}  // namespace

void build_door(Builder& b, const Opening& o) {
    constexpr float k_leaf_top = 2.45f;
    const float z = -k_reveal_m;
    const float top = std::min(k_leaf_top, o.max.y - 0.3f);
    b.picture(Surface::door, {o.min.x, o.min.y, z}, {o.max.x, o.min.y, z}, {o.max.x, top, z},
              {o.min.x, top, z}, {0.0f, 1.0f}, {1.0f, 0.0f});
    b.box(Surface::frame, {o.min.x, top, z}, {o.max.x, top + 0.10f, z + 0.06f}, k_all_sides & ~k_side_back);
    // Fanlight behind an iron grille.
    b.picture(Surface::pane, {o.min.x, top + 0.10f, z}, {o.max.x, top + 0.10f, z}, {o.max.x, o.max.y, z},
              {o.min.x, o.max.y, z}, {0.01f, 0.30f}, {0.23f, 0.02f});
    b.picture(Surface::railing, {o.min.x, top + 0.10f, z + 0.05f}, {o.max.x, top + 0.10f, z + 0.05f},
              {o.max.x, o.max.y, z + 0.05f}, {o.min.x, o.max.y, z + 0.05f}, {0.0f, 0.6f}, {1.22f, 0.16f});
    // Step of stone and a knob.
    b.box(Surface::kerb, {o.min.x, -0.1f, z}, {o.max.x, 0.06f, 0.12f},
          k_all_sides & ~(k_side_back | k_side_bottom));
    const float knob = 0.5f * (o.min.x + o.max.x) + 0.09f;
    b.box(Surface::metal, {knob - 0.02f, 1.02f, z}, {knob + 0.02f, 1.14f, z + 0.05f},
          k_all_sides & ~k_side_back);
}

FacadeLight build_shop_front(Builder& b, const Opening& o, const Evening& evening, Draws& draws) {
    const float z = -k_reveal_m;
    const float front = z + 0.06f;
    const std::uint32_t no_back = k_all_sides & ~k_side_back;
    const float door_width = 0.95f;
    const float side = draws.unit();
    const bool door_left = side < 0.5f;
    // What the halving leaves of the draw says how late the shop closes.
    const bool bright = glm::fract(2.0f * side) < evening.bright_shops;
    const float split = door_left ? o.min.x + door_width : o.max.x - door_width;
    const float window_x0 = door_left ? split : o.min.x;
    const float window_x1 = door_left ? o.max.x : split;

    b.box(Surface::shop_frame, {window_x0, 0.0f, z}, {window_x1, k_riser_m, front}, no_back);
    const std::uint32_t trade = draws.below(k_sign_cells);
    const std::uint32_t cell = k_goods[trade];
    const float u0 = (static_cast<float>(cell) + 0.01f) / static_cast<float>(k_shop_cells);
    const float u1 = (static_cast<float>(cell) + 0.99f) / static_cast<float>(k_shop_cells);
    b.picture(bright ? Surface::shop_pane : Surface::shop_pane_dark, {o.min.x, 0.0f, z}, {o.max.x, 0.0f, z},
              {o.max.x, o.max.y, z}, {o.min.x, o.max.y, z}, {u0, 0.99f}, {u1, 0.01f});
    for (const float x : {o.min.x, split - 0.5f * k_bar_m, o.max.x - k_bar_m})
        b.box(Surface::shop_frame, {x, 0.0f, z}, {x + k_bar_m, o.max.y, front + 0.02f}, no_back);
    for (const float y : {o.max.y - k_transom_m, o.max.y - k_rail_m})
        b.box(Surface::shop_frame, {o.min.x, y, z}, {o.max.x, y + k_rail_m, front}, no_back);
    const float door_x0 = door_left ? o.min.x + k_bar_m : split + 0.5f * k_bar_m;
    const float door_x1 = door_left ? split - 0.5f * k_bar_m : o.max.x - k_bar_m;
    for (const glm::vec2 board : k_door_boards)
        b.panel(Surface::shop_frame, {door_x0, board.x}, {door_x1, board.y}, z + 0.03f);

    build_sign(b, o, trade);
    const bool awning = draws.chance(0.45f);
    if (awning) build_awning(b, o);
    const float centre = 0.5f * (o.min.x + o.max.x);
    FacadeLight light{.window_m = {centre, k_riser_m, 0.45f},
                      .window_shines = bright,
                      .opening = o,
                      .glass = glass_of(o, split, door_left, u0, u1)};
    if (awning) {
        light.position_m = {centre, o.max.y - 0.35f, 0.45f};
        return light;
    }
    // A lamp on an arm over the entrance.
    b.box(Surface::iron, {centre - 0.02f, o.max.y + 0.72f, 0.0f}, {centre + 0.02f, o.max.y + 0.76f, 0.50f},
          no_back);
    b.box(Surface::iron, {centre - 0.09f, o.max.y + 0.66f, 0.38f}, {centre + 0.09f, o.max.y + 0.72f, 0.60f});
    b.box(Surface::lantern, {centre - 0.07f, o.max.y + 0.62f, 0.41f},
          {centre + 0.07f, o.max.y + 0.66f, 0.57f}, k_all_sides & ~k_side_top);
    light.position_m = {centre, o.max.y + 0.56f, 0.49f};
    light.spot = true;
    return light;
}

}  // namespace rambla::assets::generate
