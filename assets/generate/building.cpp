#include "assets/generate/building.h"

#include <array>
#include <cmath>
#include <utility>

namespace rambla::assets::generate {

namespace {

constexpr float k_foot_m = -0.3f;
constexpr float k_parapet_thick_m = 0.25f;
constexpr float k_mitre = 0.41421356f;  // tan(45° / 2)
const float k_half_root = std::sqrt(0.5f);

/// @return  the middle of its mouth
glm::vec3 build_chimney(Builder& b, glm::vec3 foot, float height) {
    b.box(Surface::plain, foot + glm::vec3{-0.3f, -0.1f, -0.3f}, foot + glm::vec3{0.3f, height, 0.3f},
          k_all_sides & ~k_side_bottom);
    b.box(Surface::trim, foot + glm::vec3{-0.38f, height, -0.38f},
          foot + glm::vec3{0.38f, height + 0.12f, 0.38f});
    b.box(Surface::plain, foot + glm::vec3{-0.18f, height + 0.12f, -0.18f},
          foot + glm::vec3{0.18f, height + 0.4f, 0.18f}, k_all_sides & ~k_side_bottom);
    return foot + glm::vec3{0.0f, height + 0.4f, 0.0f};
}

/// Stair head, chimneys and an aerial on a flat roof.
/// @param min, max  free rectangle of the roof (x, z)
/// @return  the chimneys' mouths
std::vector<glm::vec3> build_roof_things(Builder& b, glm::vec2 min, glm::vec2 max, float roof, Draws& draws) {
    const float x = draws.between(min.x, max.x - 2.6f);
    const float z = draws.between(min.y, max.y - 2.8f);
    const float head = draws.between(2.2f, 2.8f);
    b.box(Surface::wall, {x, roof - 0.1f, z}, {x + 2.4f, roof + head, z + 2.6f},
          k_all_sides & ~k_side_bottom);
    b.box(Surface::roof, {x - 0.15f, roof + head, z - 0.15f}, {x + 2.55f, roof + head + 0.14f, z + 2.75f});
    b.panel(Surface::door, {x + 0.7f, roof}, {x + 1.6f, roof + 2.0f}, z + 2.63f);
    const std::uint32_t chimneys = 1 + draws.below(3);
    std::vector<glm::vec3> mouths;
    for (std::uint32_t i = 0; i < chimneys; ++i)
        mouths.push_back(
            build_chimney(b, {draws.between(min.x + 0.5f, max.x - 0.5f), roof, draws.between(min.y, max.y)},
                          draws.between(0.8f, 1.7f)));
    const glm::vec3 aerial{draws.between(min.x + 0.5f, max.x - 0.5f), roof, draws.between(min.y, max.y)};
    b.box(Surface::iron, aerial + glm::vec3{-0.02f, 0.0f, -0.02f}, aerial + glm::vec3{0.02f, 2.6f, 0.02f});
    for (const float y : {2.0f, 2.25f, 2.5f})
        b.box(Surface::iron, aerial + glm::vec3{-0.5f, y, -0.012f},
              aerial + glm::vec3{0.5f, y + 0.024f, 0.012f});
    return mouths;
}

/// A plain wall from p to q (as seen from outside, left to right), foot to `top`.
void build_plain_wall(Builder& b, glm::vec2 p, glm::vec2 q, float top) {
    b.face(Surface::plain, {p.x, k_foot_m, p.y}, {q.x, k_foot_m, q.y}, {q.x, top, q.y}, {p.x, top, p.y});
}

}  // namespace

HouseExtras build_row_house(Builder& b, float width, const FacadeStyle& style, Draws& draws) {
    const float half = 0.5f * width;
    const float roof = style.roof_height_m();
    std::vector<FacadeLight> lights;
    {
        const InFrame scope{b, turned({-half, 0.0f, 0.0f}, 0.0f)};
        const int bays =
            width < 9.5f ? 3 : (width < 13.0f ? (draws.chance(0.5f) ? 3 : 4) : (draws.chance(0.6f) ? 4 : 5));
        lights = build_facade(b, {.width_m = width, .bays = bays}, style, draws);
    }
    for (FacadeLight& light : lights) {
        light.position_m.x -= half;
        light.window_m.x -= half;
        light.wall.origin_m.x -= half;
    }

    const float back = -k_house_depth_m;
    build_plain_wall(b, {half, back}, {-half, back}, roof + 0.3f);
    build_plain_wall(b, {-half, back}, {-half, 0.0f}, roof);
    build_plain_wall(b, {half, 0.0f}, {half, back}, roof);
    for (const bool right : {false, true}) {  // ends of the parapet
        const float x = right ? half : -half;
        const float near = right ? 0.0f : -k_parapet_thick_m;
        const float far = right ? -k_parapet_thick_m : 0.0f;
        const float top = roof + style.parapet_height_m;
        b.face(Surface::plain, {x, roof, near}, {x, roof, far}, {x, top, far}, {x, top, near});
    }
    b.box(Surface::plain, {-half, roof - 0.05f, back}, {half, roof + 0.3f, back + 0.2f},
          k_all_sides & ~k_side_back);
    b.face(Surface::roof, {-half, roof, 0.0f}, {half, roof, 0.0f}, {half, roof, back}, {-half, roof, back});
    std::vector<glm::vec3> chimneys =
        build_roof_things(b, {-half + 0.4f, back + 1.0f}, {half - 0.4f, -2.5f}, roof, draws);
    return {std::move(lights), std::move(chimneys)};
}

HouseExtras build_corner_house(Builder& b, const FacadeStyle& style, Draws& draws) {
    // Seen from above in block coordinates (u, v) along the block's two sides, cut corner at (0, 0):
    //
    //   (0,s)──────(s,s)      s = chamfer + side
    //     │          │        the chamfer's middle is this builder's origin, facing +z
    //   (0,c)        │
    //      \         │
    //      (c,0)──(s,0)
    constexpr float k_size = k_chamfer_m + k_corner_side_m;
    const glm::vec2 along_u{k_half_root, -k_half_root};  // (x, z)
    const glm::vec2 along_v{-k_half_root, -k_half_root};
    const auto at = [&](float u, float v) {
        return (u - 0.5f * k_chamfer_m) * along_u + (v - 0.5f * k_chamfer_m) * along_v;
    };
    const auto frame_at = [&](glm::vec2 origin, glm::vec2 right) {
        return Frame{{origin.x, 0.0f, origin.y},
                     {right.x, 0.0f, right.y},
                     {0.0f, 1.0f, 0.0f},
                     {-right.y, 0.0f, right.x}};
    };
    const float chamfer = k_chamfer_m / k_half_root;
    const float roof = style.roof_height_m();

    struct Side {
        Frame frame;
        FacadeSite site;
    };
    const std::array<Side, 3> sides{
        {{frame_at(at(0.0f, k_size), -along_v),
          {.width_m = k_corner_side_m, .bays = 2, .mitre_right = k_mitre, .door = false}},
         {frame_at(at(0.0f, k_chamfer_m), {1.0f, 0.0f}),
          {.width_m = chamfer, .bays = 2, .mitre_left = k_mitre, .mitre_right = k_mitre, .door = false}},
         {frame_at(at(k_chamfer_m, 0.0f), along_u),
          {.width_m = k_corner_side_m, .bays = 2, .mitre_left = k_mitre, .door = true}}}};
    std::vector<FacadeLight> lights;
    const std::uint32_t outer_group = b.group;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const InFrame scope{b, sides[i].frame};
        b.group = outer_group + static_cast<std::uint32_t>(i);
        for (FacadeLight& light : build_facade(b, sides[i].site, style, draws)) {
            light.position_m = sides[i].frame.point(light.position_m);
            light.window_m = sides[i].frame.point(light.window_m);
            light.wall = sides[i].frame * light.wall;
            lights.push_back(std::move(light));
        }
    }
    b.group = outer_group;

    const std::array<std::pair<glm::vec2, glm::vec2>, 2> walls{
        {{at(k_size, 0.0f), at(k_size, k_size)}, {at(k_size, k_size), at(0.0f, k_size)}}};
    for (const auto& wall : walls)
        build_plain_wall(b, wall.first, wall.second, roof + style.parapet_height_m);
    for (const auto& wall : walls)  // their inner sides, above the roof
        b.face(Surface::plain, {wall.second.x, roof - 0.05f, wall.second.y},
               {wall.first.x, roof - 0.05f, wall.first.y},
               {wall.first.x, roof + style.parapet_height_m, wall.first.y},
               {wall.second.x, roof + style.parapet_height_m, wall.second.y});
    std::array<glm::vec3, 5> outline;
    const std::array<glm::vec2, 5> corners{at(k_chamfer_m, 0.0f), at(k_size, 0.0f), at(k_size, k_size),
                                           at(0.0f, k_size), at(0.0f, k_chamfer_m)};
    for (std::size_t i = 0; i < outline.size(); ++i)
        outline[i] = {corners[i].x, roof, corners[i].y};
    b.polygon(Surface::roof, outline);
    std::vector<glm::vec3> chimneys = build_roof_things(b, {-2.2f, -9.5f}, {2.2f, -4.0f}, roof, draws);
    return {std::move(lights), std::move(chimneys)};
}

}  // namespace rambla::assets::generate
