#include <array>
#include <cmath>

#include "assets/generate/facade.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

/// Windows in front of which nobody ever draws shutters: by day these are the lit ones.
constexpr float k_open_share = 1.0f / 7.0f;

/// What shines behind a window. @param place  in [0, 1), of its people in the order in which they go to bed
Surface pane_of(const Evening& evening, float place) {
    if (place < evening.warm_windows) return Surface::pane_lit;
    return place >= 1.0f - evening.blue_windows ? Surface::pane_blue : Surface::pane;
}

/// A pane that shows one cell of its picture; insets keep the neighbours out of the filter.
void build_pane(Builder& b, Surface surface, const Opening& o, std::uint32_t cell, std::uint32_t cells) {
    const float width = 1.0f / static_cast<float>(cells);
    const float inset = 0.02f * width;
    const float left = static_cast<float>(cell) * width;
    b.picture(surface, {o.min.x, o.min.y, -k_reveal_m}, {o.max.x, o.min.y, -k_reveal_m},
              {o.max.x, o.max.y, -k_reveal_m}, {o.min.x, o.max.y, -k_reveal_m}, {left + inset, 0.985f},
              {left + width - inset, 0.015f});
}

/// Two leaves with a solid foot and cross bars, 4 cm before the pane.
void build_casement(Builder& b, const Opening& o) {
    constexpr float k_stile = 0.065f;
    const float z = -k_reveal_m + 0.04f;
    const float middle = 0.5f * (o.min.x + o.max.x);
    const float height = o.max.y - o.min.y;
    const float foot = height > 2.0f ? 0.42f : 0.08f;
    b.panel(Surface::frame, {o.min.x, o.min.y}, {o.min.x + k_stile, o.max.y}, z);
    b.panel(Surface::frame, {o.max.x - k_stile, o.min.y}, {o.max.x, o.max.y}, z);
    b.box(Surface::frame, {middle - 0.055f, o.min.y, z}, {middle + 0.055f, o.max.y, z + 0.025f},
          k_side_left | k_side_right | k_side_front);
    for (const auto& [x0, x1] :
         {std::pair{o.min.x + k_stile, middle - 0.055f}, {middle + 0.055f, o.max.x - k_stile}}) {
        b.panel(Surface::frame, {x0, o.min.y}, {x1, o.min.y + foot}, z);
        b.panel(Surface::frame, {x0, o.max.y - 0.07f}, {x1, o.max.y}, z);
        const float transom = o.max.y - 0.30f * height;
        b.panel(Surface::frame, {x0, transom}, {x1, transom + 0.05f}, z);
        if (height < 2.0f) continue;
        const float bar = 0.5f * (o.min.y + foot + transom);
        b.panel(Surface::frame, {x0, bar}, {x1, bar + 0.035f}, z);
    }
}

/// One shutter leaf hung at x; `open_rad` turns it from closed (0) outwards.
void build_leaf(Builder& b, glm::vec3 hinge, float width, float height, float open_rad, bool left) {
    constexpr float k_thick = 0.035f;
    const float angle = left ? -open_rad : open_rad;
    const InFrame scope{b, turned(hinge, angle)};
    const float x0 = left ? 0.0f : -width;
    const float x1 = left ? width : 0.0f;
    // The picture shows stiles left and right, so a leaf spans it once across and in metres along.
    b.picture(Surface::shutter, {x0, 0.0f, k_thick}, {x1, 0.0f, k_thick}, {x1, height, k_thick},
              {x0, height, k_thick}, {0.0f, 0.0f}, {1.0f, -height});
    b.picture(Surface::shutter, {x1, 0.0f, 0.0f}, {x0, 0.0f, 0.0f}, {x0, height, 0.0f}, {x1, height, 0.0f},
              {0.0f, 0.0f}, {1.0f, -height});
    b.box(Surface::shutter, {x0, 0.0f, 0.0f}, {x1, height, k_thick}, k_side_left | k_side_right);
}

}  // namespace

void build_window(Builder& b, const Opening& o, const FacadeStyle& style, Draws& draws) {
    const float place = draws.unit();
    build_pane(b, pane_of(style.evening, place), o, draws.below(k_window_cells), k_window_cells);
    build_casement(b, o);
    const float mood = draws.unit();
    const float slack = draws.unit();
    if (!style.shutters || place < k_open_share) return;
    if (mood < 0.25f) return;  // no shutters drawn out
    const float half = 0.5f * (o.max.x - o.min.x);
    const float height = o.max.y - o.min.y - 0.04f;
    // Flat against the wall, half open, or closed; flat leaves stand off the surround.
    const float open = mood < 0.70f ? 3.02f - 0.10f * slack : (mood < 0.88f ? 1.5f + 0.9f * slack : 0.0f);
    const float z = open == 0.0f ? -0.08f : 0.06f;
    build_leaf(b, {o.min.x, o.min.y + 0.02f, z}, half - 0.01f, height, open, true);
    build_leaf(b, {o.max.x, o.min.y + 0.02f, z}, half - 0.01f, height,
               open == 0.0f ? 0.0f : open - 0.3f * slack, false);
}

void build_balcony(Builder& b, float x0, float x1, float y, Draws& draws) {
    constexpr float k_depth = 0.72f;
    constexpr float k_height = 1.02f;
    constexpr float k_inset = 0.05f;
    const std::array<glm::vec2, 5> slab{{{0.0f, y - 0.16f},
                                         {k_depth - 0.07f, y - 0.15f},
                                         {k_depth, y - 0.09f},
                                         {k_depth, y},
                                         {0.0f, y + 0.005f}}};
    b.moulding(Surface::trim, slab, x0, x1, 0.0f, 0.0f);
    const std::array<glm::vec2, 4> bracket{
        {{0.0f, y - 0.52f}, {0.10f, y - 0.50f}, {0.48f, y - 0.16f}, {0.0f, y - 0.15f}}};
    const int count = std::max(2, static_cast<int>((x1 - x0) / 1.6f) + 1);
    for (int i = 0; i < count; ++i) {
        const float x =
            x0 + 0.22f + (x1 - x0 - 0.44f) * static_cast<float>(i) / static_cast<float>(count - 1);
        b.moulding(Surface::trim, bracket, x - 0.06f, x + 0.06f, 0.0f, 0.0f);
    }
    const float left = x0 + k_inset;
    const float right = x1 - k_inset;
    const float front = k_depth - k_inset;
    const float top = y + k_height;
    const auto rail = [&](glm::vec3 from, glm::vec3 to) {
        // Whole bars: the picture's metre is stretched by at most a few per cent.
        const float bars = std::max(1.0f, std::round(glm::length(to - from) * 9.0f)) / 9.0f;
        const glm::vec3 up{0.0f, k_height, 0.0f};
        b.picture(Surface::railing, from, to, to + up, from + up, {0.0f, 0.998f}, {bars, 0.002f});
    };
    rail({left, y, front}, {right, y, front});
    rail({left, y, 0.0f}, {left, y, front});
    rail({right, y, front}, {right, y, 0.0f});
    constexpr float k_half = 0.022f;
    b.box(Surface::iron, {left - k_half, top, front - k_half},
          {right + k_half, top + 0.035f, front + k_half});
    for (const float x : {left, right})
        b.box(Surface::iron, {x - k_half, top, 0.0f}, {x + k_half, top + 0.035f, front - k_half},
              k_all_sides & ~(k_side_back | k_side_front));
    if (!draws.chance(0.3f)) return;
    // A trough of plants that lean over the rail.
    const float centre = draws.between(left + 0.4f, right - 0.4f);
    b.box(Surface::timber, {centre - 0.35f, y + 0.01f, front - 0.26f},
          {centre + 0.35f, y + 0.22f, front - 0.06f}, k_all_sides & ~k_side_bottom);
    for (int i = 0; i < 5; ++i) {
        const float x = centre - 0.28f + 0.14f * static_cast<float>(i);
        const float turn = draws.between(-0.7f, 0.7f);
        const InFrame scope{b, turned({x, y + 0.42f, front - 0.14f}, turn)};
        constexpr float k_size = 0.26f;
        const glm::vec3 soft = glm::normalize(glm::vec3{0.0f, 0.5f, 0.85f});
        const float cell = static_cast<float>(draws.below(k_leaf_cells)) / static_cast<float>(k_leaf_cells);
        b.card(Surface::foliage,
               {glm::vec3{-k_size, -k_size, 0.0f},
                {k_size, -k_size, 0.0f},
                {k_size, k_size, 0.02f},
                {-k_size, k_size, 0.02f}},
               {soft, soft, soft, soft}, {cell, 1.0f},
               {cell + 1.0f / static_cast<float>(k_leaf_cells), 0.0f});
    }
}

}  // namespace rambla::assets::generate
