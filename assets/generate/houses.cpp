#include "assets/generate/houses.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "assets/generate/haze.h"
#include "assets/generate/node.h"

namespace rambla::assets::generate {

namespace {

constexpr std::size_t k_variants = 6;
constexpr std::size_t k_corner_variants = 6;
constexpr std::size_t k_plaster_schemes = 14;
constexpr std::size_t k_brick_schemes = 2;
constexpr glm::vec3 k_shop_light{1.0f, 0.80f, 0.55f};

/// Three to six upper storeys, each height among every width's variants.
int storeys_of(std::size_t variant) {
    return 3 + static_cast<int>(variant % 4);
}

}  // namespace

Transform transform_of(const Frame& frame) {
    const float angle = std::atan2(frame.out.x, frame.out.z);
    Transform transform;
    transform.translation_m = frame.origin_m;
    transform.rotation = {std::cos(0.5f * angle), 0.0f, std::sin(0.5f * angle), 0.0f};
    return transform;
}

Houses::Houses(Scene& scene, const Palette& palette, const Evening& evening, std::uint64_t seed)
    : scene_{scene},
      shop_pane_{palette.standard[static_cast<std::size_t>(Surface::shop_pane)]},
      lamps_{evening.lamps},
      lamp_share_{evening.lamps_at_shops} {
    struct Built {
        std::vector<Builder::Part> parts;
        HouseExtras extras;
        FacadeStyle style;
    };
    constexpr std::size_t k_rows = k_widths_m.size() * k_variants;
    std::vector<Built> built(k_rows + k_corner_variants);
    tbb::parallel_for(std::size_t{0}, built.size(), [&](std::size_t i) {
        Draws draws{seed, i};
        Builder builder;
        Built& house = built[i];
        if (i < k_rows) {
            house.style = draw_style(draws, storeys_of(i % k_variants), evening);
            house.extras = build_row_house(builder, k_widths_m[i / k_variants], house.style, draws);
            house.parts = builder.take("house-" + std::to_string(i));
        } else {
            house.style = draw_style(draws, 3 + static_cast<int>(i % 3), evening);
            house.extras = build_corner_house(builder, house.style, draws);
            house.parts = builder.take("corner-" + std::to_string(i - k_rows));
        }
    });
    row_houses_.resize(k_widths_m.size());
    for (std::size_t i = 0; i < built.size(); ++i) {
        auto& list = i < k_rows ? row_houses_[i / k_variants] : corner_houses_;
        std::vector<std::vector<GlowingGlass>> glass;
        for (const FacadeLight& light : built[i].extras.lights)
            glass.push_back(glowing(light));
        list.push_back({store(scene_, std::move(built[i].parts)), std::move(built[i].extras),
                        std::move(glass), built[i].style});
    }
    Draws draws{seed, built.size()};
    for (std::size_t i = 0; i < k_plaster_schemes; ++i)
        plaster_schemes_.push_back(building_scheme(palette, draws, false));
    for (std::size_t i = 0; i < k_brick_schemes; ++i)
        brick_schemes_.push_back(building_scheme(palette, draws, true));
    smoke_ = add_smoke(scene_);
    lamp_ = add_lamp(scene_, "shop-lamp", LightKind::point, k_shop_light, 1.6f, 4.5f);
    spot_ = add_lamp(scene_, "shop-spot", LightKind::spot, k_shop_light, 4.0f, 6.0f);
    if (evening.lamps > 0.0f) {
        // For what stands and walks before a window: it shines upwards, since the ground's share is baked.
        window_ = add_lamp(scene_, "shop-window", LightKind::spot, k_shop_light, 0.45f * evening.lamps, 4.0f);
        scene_.lights[window_].inner_cone_rad = 1.2f;
        scene_.lights[window_].outer_cone_rad = 1.5f;
    }
}

std::vector<GlowingGlass> Houses::glowing(const FacadeLight& light) const {
    std::vector<GlowingGlass> result;
    if (lamps_ == 0.0f || !light.window_shines) return result;
    for (const Glass& glass : light.glass)
        result.push_back({glass.at, lamps_ * mean_emission(scene_, shop_pane_, glass.uv_min, glass.uv_max)});
    return result;
}

std::vector<ShopWindow> Houses::take_lit_shops() {
    return std::exchange(lit_shops_, {});
}

void Houses::add_row_house(float width, const Frame& at, int most_storeys, Draws& draws) {
    const auto found = std::min_element(k_widths_m.begin(), k_widths_m.end(), [&](float a, float b) {
        return std::abs(a - width) < std::abs(b - width);
    });
    add(row_houses_[static_cast<std::size_t>(found - k_widths_m.begin())], most_storeys, "house", at, draws);
}

void Houses::add_corner_house(const Frame& at, int most_storeys, Draws& draws) {
    add(corner_houses_, most_storeys, "corner-house", at, draws);
}

void Houses::add(const std::vector<House>& houses, int most_storeys, const char* name, const Frame& at,
                 Draws& draws) {
    std::vector<const House*> fitting;
    for (const House& candidate : houses)
        if (candidate.style.upper_storeys <= most_storeys) fitting.push_back(&candidate);
    const House& house = *fitting[draws.below(static_cast<std::uint32_t>(fitting.size()))];
    const auto& schemes = house.style.brick ? brick_schemes_ : plaster_schemes_;
    const std::size_t scheme = draws.below(static_cast<std::uint32_t>(schemes.size()));
    auto [model, fresh] = models_.try_emplace({&house, scheme}, k_none);
    if (fresh) model->second = add_model(scene_, name, house.parts, schemes[scheme]);

    const std::uint32_t node = add_node(scene_, name, k_none, transform_of(at));
    scene_.nodes[node].model = model->second;
    scene_.roots.push_back(node);
    // Lights shine along −z; a quarter turn about x points that up or down.
    const glm::quat level{1.0f, 0.0f, 0.0f, 0.0f};
    const glm::quat down{std::sqrt(0.5f), -std::sqrt(0.5f), 0.0f, 0.0f};
    const glm::quat up{std::sqrt(0.5f), std::sqrt(0.5f), 0.0f, 0.0f};
    const auto shine = [&](const char* what, std::uint32_t light, glm::vec3 at_m, const glm::quat& aim) {
        Transform local;
        local.translation_m = at_m;
        local.rotation = aim;
        scene_.nodes[add_node(scene_, what, node, local)].light = light;
    };
    // Somebody cooks in every third house, on one stove, at any time of day.
    const bool smokes = houses_added_++ % 3 == 0 && !house.extras.chimneys_m.empty();
    if (smokes)
        add_emitter_node(scene_, smoke_, node, house.extras.chimneys_m.front(),
                         scene_.nodes[node].local.rotation);
    for (std::size_t i = 0; i < house.extras.lights.size(); ++i) {
        const FacadeLight& light = house.extras.lights[i];
        if (!house.glass[i].empty()) lit_shops_.push_back({at * light.wall, light.opening, house.glass[i]});
        if (window_ != k_none && light.window_shines) shine("shop-window", window_, light.window_m, up);
        if (!draws.chance(lamp_share_)) continue;
        shine(light.spot ? "shop-spot" : "shop-lamp", light.spot ? spot_ : lamp_, light.position_m,
              light.spot ? down : level);
    }
}

}  // namespace rambla::assets::generate
