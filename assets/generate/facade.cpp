#include "assets/generate/facade.h"

#include <algorithm>
#include <array>

namespace rambla::assets::generate {

namespace {

constexpr float k_plinth_m = 0.04f;
constexpr float k_below_ground_m =
    0.3f;  // walls reach below the pavement, so that no gap shows at their foot

/// Left edges of `bays` openings of one width, spread evenly.
std::vector<float> bay_edges(float width, int bays, float opening_width) {
    std::vector<float> edges;
    const float bay = width / static_cast<float>(bays);
    for (int i = 0; i < bays; ++i)
        edges.push_back((static_cast<float>(i) + 0.5f) * bay - 0.5f * opening_width);
    return edges;
}

void build_string_course(Builder& b, const FacadeSite& site, float y) {
    const std::array<glm::vec2, 6> profile{{{0.0f, y - 0.14f},
                                            {0.06f, y - 0.10f},
                                            {0.06f, y + 0.02f},
                                            {0.12f, y + 0.06f},
                                            {0.12f, y + 0.13f},
                                            {0.0f, y + 0.16f}}};
    b.moulding(Surface::trim, profile, 0.0f, site.width_m, site.mitre_left, site.mitre_right);
}

void build_cornice(Builder& b, const FacadeSite& site, const FacadeStyle& style, float y) {
    const std::array<glm::vec2, 8> profile{{{0.0f, y - 0.62f},
                                            {0.05f, y - 0.58f},
                                            {0.05f, y - 0.32f},
                                            {0.30f, y - 0.24f},
                                            {0.34f, y - 0.12f},
                                            {0.45f, y - 0.05f},
                                            {0.45f, y + 0.04f},
                                            {0.0f, y + 0.10f}}};
    b.moulding(Surface::trim, profile, 0.0f, site.width_m, site.mitre_left, site.mitre_right);
    if (!style.dentils) return;
    const int count = static_cast<int>(site.width_m / 0.5f);
    const float step = site.width_m / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        const float x = (static_cast<float>(i) + 0.5f) * step;
        b.box(Surface::trim, {x - 0.09f, y - 0.50f, 0.0f}, {x + 0.09f, y - 0.28f, 0.20f},
              k_all_sides & ~(k_side_back | k_side_top));
    }
}

void build_parapet(Builder& b, const FacadeSite& site, const FacadeStyle& style) {
    const float roof = style.roof_height_m();
    const float top = roof + style.parapet_height_m;
    const std::array<glm::vec2, 4> wall{{{0.0f, roof}, {0.0f, top}, {-0.25f, top}, {-0.25f, roof - 0.05f}}};
    b.moulding(Surface::wall, wall, 0.0f, site.width_m, site.mitre_left, site.mitre_right, false);
    const std::array<glm::vec2, 5> coping{
        {{-0.28f, top}, {0.06f, top}, {0.06f, top + 0.09f}, {-0.31f, top + 0.11f}, {-0.28f, top}}};
    b.moulding(Surface::trim, coping, 0.0f, site.width_m, site.mitre_left, site.mitre_right, false);
    for (const bool right : {false, true}) {
        if ((right ? site.mitre_right : site.mitre_left) != 0.0f) continue;
        const float x = right ? site.width_m : 0.0f;
        const glm::vec3 front{x, 0.0f, 0.06f};
        const glm::vec3 back{x, 0.0f, -0.30f};
        const auto up = [](glm::vec3 p, float y) {
            return glm::vec3{p.x, y, p.z};
        };
        const glm::vec3 near = right ? front : back;
        const glm::vec3 far = right ? back : front;
        b.face(Surface::trim, up(near, top), up(far, top), up(far, top + 0.09f), up(near, top + 0.09f));
    }
}

void build_surround(Builder& b, const Opening& o) {
    constexpr float k_width = 0.14f;
    constexpr float k_out = 0.045f;
    const std::uint32_t no_back = k_all_sides & ~k_side_back;
    b.box(Surface::trim, {o.min.x - k_width, o.min.y, 0.0f}, {o.min.x, o.max.y, k_out},
          no_back & ~k_side_top);
    b.box(Surface::trim, {o.max.x, o.min.y, 0.0f}, {o.max.x + k_width, o.max.y, k_out},
          no_back & ~k_side_top);
    const std::array<glm::vec2, 5> lintel{{{0.0f, o.max.y},
                                           {0.06f, o.max.y},
                                           {0.06f, o.max.y + 0.18f},
                                           {0.13f, o.max.y + 0.24f},
                                           {0.0f, o.max.y + 0.29f}}};
    b.moulding(Surface::trim, lintel, o.min.x - k_width - 0.03f, o.max.x + k_width + 0.03f, 0.0f, 0.0f);
}

void build_upper_storeys(Builder& b, const FacadeSite& site, const FacadeStyle& style, Draws& draws) {
    const std::vector<float> bays = bay_edges(site.width_m, site.bays, style.window_width_m);
    std::vector<float> columns{0.0f};
    for (const float x : bays) {
        columns.push_back(x);
        columns.push_back(x + style.window_width_m);
    }
    columns.push_back(site.width_m);

    struct Storey {
        float floor, bottom, top;
        BalconyKind balcony;
    };
    std::vector<Storey> storeys;
    std::vector<float> levels{style.ground_height_m};
    for (int i = 0; i < style.upper_storeys; ++i) {
        const float floor = style.ground_height_m + style.storey_height_m * static_cast<float>(i) + 0.16f;
        const bool last = i + 1 == style.upper_storeys;
        BalconyKind balcony = i == 0 ? style.first_floor_balcony : BalconyKind::none;
        if (i > 0 && !last && style.upper_balconies) balcony = BalconyKind::single;
        const float bottom = balcony == BalconyKind::none ? floor + 0.85f : floor + 0.02f;
        const float top = floor + (last ? 2.25f : 2.45f);
        storeys.push_back({floor, bottom, top, balcony});
        levels.push_back(bottom);
        levels.push_back(top);
    }
    levels.push_back(style.roof_height_m());
    build_pierced_wall(b, Surface::wall, columns, levels);

    for (const Storey& storey : storeys) {
        for (const float x : bays) {
            const Opening opening{{x, storey.bottom}, {x + style.window_width_m, storey.top}};
            build_reveal(b, Surface::wall, opening);
            build_window(b, opening, style, draws);
            if (style.surrounds) build_surround(b, opening);
            if (storey.balcony == BalconyKind::single)
                build_balcony(b, x - 0.36f, opening.max.x + 0.36f, storey.floor, draws);
            if (storey.balcony == BalconyKind::none)
                b.box(Surface::trim, {x - 0.10f, storey.bottom - 0.09f, 0.0f},
                      {opening.max.x + 0.10f, storey.bottom, 0.11f}, k_all_sides & ~k_side_back);
        }
        if (storey.balcony == BalconyKind::continuous)
            build_balcony(b, bays.front() - 0.45f, bays.back() + style.window_width_m + 0.45f, storey.floor,
                          draws);
    }
}

std::vector<FacadeLight> build_ground_floor(Builder& b, const FacadeSite& site, const FacadeStyle& style,
                                            Draws& draws) {
    constexpr float k_door_m = 1.35f;
    const float bay = site.width_m / static_cast<float>(site.bays);
    const float shop_width = std::min(bay - 0.7f, 2.9f);
    const int door_bay =
        site.door ? static_cast<int>(draws.below(static_cast<std::uint32_t>(site.bays))) : -1;
    const float top = style.ground_height_m - 1.05f;

    std::vector<float> columns{0.0f};
    std::vector<Opening> openings;
    for (int i = 0; i < site.bays; ++i) {
        const float width = i == door_bay ? k_door_m : shop_width;
        const float centre = (static_cast<float>(i) + 0.5f) * bay;
        openings.push_back({{centre - 0.5f * width, 0.0f}, {centre + 0.5f * width, top}});
        columns.push_back(openings.back().min.x);
        columns.push_back(openings.back().max.x);
    }
    columns.push_back(site.width_m);
    build_pierced_wall(b, Surface::base, columns, {-k_below_ground_m, 0.0f, top, style.ground_height_m});

    // Plinths stand between the openings.
    for (std::size_t i = 0; i + 1 < columns.size(); i += 2) {
        const bool first = i == 0;
        const bool last = i + 2 == columns.size();
        const std::array<glm::vec2, 3> profile{
            {{k_plinth_m, -k_below_ground_m}, {k_plinth_m, 0.55f}, {0.0f, 0.60f}}};
        b.moulding(Surface::kerb, profile, columns[i], columns[i + 1], first ? site.mitre_left : 0.0f,
                   last ? site.mitre_right : 0.0f);
    }

    std::vector<FacadeLight> lights;
    for (int i = 0; i < site.bays; ++i) {
        const Opening& opening = openings[static_cast<std::size_t>(i)];
        build_reveal(b, Surface::base, opening);
        if (i == door_bay)
            build_door(b, opening);
        else
            lights.push_back(build_shop_front(b, opening, style.evening, draws));
    }
    return lights;
}

}  // namespace

FacadeStyle draw_style(Draws& draws, int upper_storeys, const Evening& evening) {
    FacadeStyle style;
    style.evening = evening;
    style.upper_storeys = upper_storeys;
    style.ground_height_m = draws.between(3.9f, 4.4f);
    style.storey_height_m = draws.between(3.05f, 3.35f);
    style.window_width_m = draws.between(1.08f, 1.28f);
    style.parapet_height_m = draws.between(0.7f, 1.1f);
    const float kind = draws.unit();
    style.first_floor_balcony = kind < 0.45f ? BalconyKind::continuous : BalconyKind::single;
    style.upper_balconies = draws.chance(0.75f);
    style.surrounds = draws.chance(0.65f);
    style.shutters = draws.chance(0.7f);
    style.dentils = draws.chance(0.5f);
    style.brick = draws.chance(0.14f);
    style.upper_course = draws.chance(0.3f);
    return style;
}

void build_pierced_wall(Builder& b, Surface surface, const std::vector<float>& columns,
                        const std::vector<float>& levels) {
    for (std::size_t row = 0; row + 1 < levels.size(); ++row) {
        for (std::size_t column = 0; column + 1 < columns.size(); ++column) {
            if ((row & 1u) && (column & 1u)) continue;
            b.panel(surface, {columns[column], levels[row]}, {columns[column + 1], levels[row + 1]}, 0.0f);
        }
    }
}

void build_reveal(Builder& b, Surface surface, const Opening& o) {
    const float z = -k_reveal_m;
    b.face(surface, {o.min.x, o.min.y, 0.0f}, {o.min.x, o.min.y, z}, {o.min.x, o.max.y, z},
           {o.min.x, o.max.y, 0.0f});
    b.face(surface, {o.max.x, o.min.y, z}, {o.max.x, o.min.y, 0.0f}, {o.max.x, o.max.y, 0.0f},
           {o.max.x, o.max.y, z});
    b.face(surface, {o.min.x, o.max.y, z}, {o.max.x, o.max.y, z}, {o.max.x, o.max.y, 0.0f},
           {o.min.x, o.max.y, 0.0f});
    b.face(surface, {o.min.x, o.min.y, 0.0f}, {o.max.x, o.min.y, 0.0f}, {o.max.x, o.min.y, z},
           {o.min.x, o.min.y, z});
}

std::vector<FacadeLight> build_facade(Builder& b, const FacadeSite& site, const FacadeStyle& style,
                                      Draws& draws) {
    std::vector<FacadeLight> lights = build_ground_floor(b, site, style, draws);
    build_upper_storeys(b, site, style, draws);
    build_string_course(b, site, style.ground_height_m);
    if (style.upper_course)
        build_string_course(
            b, site,
            style.ground_height_m + style.storey_height_m * static_cast<float>(style.upper_storeys - 1));
    build_cornice(b, site, style, style.roof_height_m());
    build_parapet(b, site, style);
    return lights;
}

}  // namespace rambla::assets::generate
