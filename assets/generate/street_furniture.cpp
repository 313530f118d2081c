#include "assets/generate/street_furniture.h"

#include <tbb/parallel_for.h>

#include "assets/generate/furniture.h"
#include "assets/generate/haze.h"
#include "assets/generate/houses.h"
#include "assets/generate/node.h"
#include "assets/generate/tree.h"

namespace rambla::assets::generate {

namespace {

using Thing = StreetThings::Thing;

constexpr std::array<const char*, StreetThings::k_things> k_names{
    "tree",  "tree",    "tree",       "tree-pit", "lamp-post", "wall-lantern",
    "bench", "bollard", "litter-bin", "manhole",  "drain",     "crossing"};

void build(Builder& builder, Thing thing, const StreetPlan& plan, Draws draws) {
    switch (thing) {
        case Thing::tree_a:
        case Thing::tree_b:
        case Thing::tree_c:
            return build_tree(builder, draws);
        case Thing::tree_pit:
            return build_tree_pit(builder);
        case Thing::lamp_post:
            return build_lamp_post(builder);
        case Thing::wall_lantern:
            return build_wall_lantern(builder);
        case Thing::bench:
            return build_bench(builder);
        case Thing::bollard:
            return build_bollard(builder);
        case Thing::litter_bin:
            return build_litter_bin(builder);
        case Thing::manhole:
            return build_manhole(builder);
        case Thing::drain:
            return build_drain(builder);
        case Thing::crossing:
            return build_crossing(builder, plan);
    }
}

Frame within(const Frame& at, float x, float z, float angle_rad = 0.0f) {
    return at * turned({x, 0.0f, z}, angle_rad);
}

/// Trees need this much pavement, or their crowns grow into the façade and their pits close the way.
constexpr float k_tree_pavement_m = 2.0f;

}  // namespace

StreetThings::StreetThings(Scene& scene, const Palette& palette, const StreetPlan& plan,
                           const Evening& evening, std::uint64_t seed)
    : scene_{scene}, plan_{plan} {
    std::array<std::vector<Builder::Part>, k_things> built;
    tbb::parallel_for(std::size_t{0}, k_things, [&](std::size_t i) {
        Builder builder;
        build(builder, static_cast<Thing>(i), plan, Draws{seed, i});
        built[i] = builder.take(k_names[i]);
    });
    for (std::size_t i = 0; i < k_things; ++i)
        models_[i] = add_model(scene_, k_names[i], store(scene_, std::move(built[i])), palette.standard);
    if (evening.lamps == 0.0f) return;
    post_light_ =
        add_lamp(scene_, "street-lamp", LightKind::point, k_light_2700k, 5.0f * evening.lamps, 13.0f);
    const glm::vec3 glass = evening.lamps * k_light_2700k;
    glows_ = {add_glow(scene_, "lantern-glow", glass, 0.45f, 0.12f),
              add_glow(scene_, "lantern-haze", glass, 1.6f, 0.035f)};
    vapour_ = add_vapour(scene_);
    wall_light_ = add_lamp(scene_, "wall-lamp", LightKind::point, k_light_3000k, 3.0f * evening.lamps, 10.0f);
}

void StreetThings::add(Thing thing, const Frame& at) {
    const auto index = static_cast<std::size_t>(thing);
    const std::uint32_t node = add_node(scene_, k_names[index], k_none, transform_of(at));
    scene_.nodes[node].model = models_[index];
    scene_.roots.push_back(node);
    const glm::quat rotation = scene_.nodes[node].local.rotation;
    const bool steams = thing == Thing::manhole && manholes_added_++ % 2 == 0;
    if (steams && vapour_ != k_none) add_emitter_node(scene_, vapour_, node, glm::vec3{0.0f}, rotation);
    if (post_light_ == k_none || (thing != Thing::lamp_post && thing != Thing::wall_lantern)) return;
    Transform flame;
    flame.translation_m = thing == Thing::lamp_post ? k_post_flame_m : k_wall_flame_m;
    scene_.nodes[add_node(scene_, "light", node, flame)].light =
        thing == Thing::lamp_post ? post_light_ : wall_light_;
    for (const std::uint32_t glow : glows_)
        add_emitter_node(scene_, glow, node, flame.translation_m, rotation);
}

void StreetThings::furnish_side(const Frame& at, float length, bool trees, Draws& draws) {
    const float z = plan_.furniture_m();
    const bool room = plan_.pavement_m() >= k_tree_pavement_m;
    const float free = length - 6.0f;  // crossings stay clear
    if (trees && room) {
        constexpr float k_spacing_m = 11.0f;
        const int count = std::max(1, static_cast<int>(free / k_spacing_m));
        const float step = free / static_cast<float>(count);
        for (int i = 0; i < count; ++i) {
            const float x = -0.5f * free + (static_cast<float>(i) + 0.5f) * step;
            const auto kind = static_cast<Thing>(draws.below(3));
            add(kind, within(at, x, z, draws.between(0.0f, 6.28f)));
            add(Thing::tree_pit, within(at, x, z));
            const float between = x + 0.5f * step;
            if (i + 1 == count) break;
            const float what = draws.unit();
            if (what < 0.55f)
                add(Thing::bench, within(at, between, z + 0.05f, 3.14159265f));
            else if (what < 0.8f)
                add(Thing::litter_bin, within(at, between, z));
            else
                add(Thing::lamp_post, within(at, between, z + 0.12f));
        }
    } else {
        for (const float share : {-0.33f, 0.0f, 0.33f})
            add(Thing::lamp_post, within(at, share * free, z + 0.12f));
        if (draws.chance(0.5f)) add(Thing::litter_bin, within(at, 0.18f * free, z + 0.05f));
    }
    const float gutter = plan_.pavement_m() + 0.14f;
    // Road things lie one kerb lower than the pavement that the frame stands on.
    for (const float share : {-0.42f, 0.42f}) {
        Frame drain = within(at, share * length, gutter);
        drain.origin_m.y -= k_kerb_height_m;
        add(Thing::drain, drain);
    }
    if (draws.chance(0.6f)) {
        Frame manhole =
            within(at, draws.between(-0.3f, 0.3f) * length, plan_.pavement_m() + draws.between(1.2f, 1.8f));
        manhole.origin_m.y -= k_kerb_height_m;
        add(Thing::manhole, manhole);
    }
}

void StreetThings::furnish_corner(const Frame& at) {
    const float z = plan_.pavement_m() - 0.33f;
    for (const float x : {-2.7f, -0.9f, 0.9f, 2.7f})
        add(Thing::bollard, within(at, x, z));
}

}  // namespace rambla::assets::generate
