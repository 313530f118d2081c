#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "assets/generate/evening.h"
#include "unit/assets/generate_support.h"

namespace rambla::assets::test {
namespace {

using generate::Evening;
using generate::evening_at;

const char* const k_small = "city:blocks=1x1,walkers=0,cars=0";

/// Panes shown in materials of a name, each house counted as often as it stands there.
std::size_t panes(const Scene& scene, const std::string& material) {
    std::size_t count = 0;
    for (const Shown& shown : shown_models(scene)) {
        for (const ModelPart& part : scene.models[shown.model].parts)
            if (scene.materials[part.material].name == material)
                count += scene.meshes[part.mesh].indices.size() / 6;
    }
    return count;
}

std::size_t lights(const Scene& scene, const std::string& name) {
    std::size_t count = 0;
    for (const Node& node : scene.nodes)
        count += node.light != k_none && scene.lights[node.light].name == name ? 1 : 0;
    return count;
}

std::size_t emitters(const Scene& scene, const std::string& name) {
    std::size_t count = 0;
    for (const Node& node : scene.nodes)
        count += node.emitter != k_none && scene.emitters[node.emitter].name == name ? 1 : 0;
    return count;
}

glm::vec3 emission(const Scene& scene, const std::string& material) {
    for (const Material& m : scene.materials)
        if (m.name == material) return m.emissive;
    ADD_FAILURE() << material;
    return {};
}

TEST(Evening, LampsAreOffByDayAndGoOnInTheTwilight) {
    EXPECT_EQ(evening_at({}).lamps, 0.0f);
    EXPECT_EQ(evening_at(k_dusk).lamps, 1.0f);
    EXPECT_EQ(evening_at(k_night).lamps, 1.0f);
    float before = 0.0f;
    for (int m = 12 * 60; m < 24 * 60; ++m) {
        const float lamps = evening_at({m}).lamps;
        EXPECT_GE(lamps, before) << m;
        EXPECT_LT(lamps - before, 0.06f) << m;  // the ramp takes half an hour
        if (sun_height_sine({m}) > std::sin(glm::radians(4.0f))) {
            EXPECT_EQ(lamps, 0.0f) << m;
        }
        before = lamps;
    }
}

TEST(Evening, SharesStayWithinTheWholeAndFewAreUpAfterMidnight) {
    for (int m = 0; m < 24 * 60; ++m) {
        const Evening e = evening_at({m});
        for (const float share : {e.warm_windows, e.blue_windows, e.bright_shops, e.lamps_at_shops}) {
            EXPECT_GE(share, 0.0f) << m;
            EXPECT_LE(share, 1.0f) << m;
        }
        EXPECT_LT(e.warm_windows + e.blue_windows, 0.4f) << "most are dark";
    }
    EXPECT_LT(evening_at({120}).warm_windows, 0.25f * evening_at(k_night).warm_windows);
}

TEST(Evening, StreetLampsShineAtNightOnly) {
    const Scene day = generate_place(k_small, 1).scene;
    const Scene night = generate_place(k_small, 1, k_night).scene;
    EXPECT_EQ(lights(day, "street-lamp") + lights(day, "wall-lamp"), 0u);
    EXPECT_EQ(emission(day, "street-lantern"), glm::vec3{0.0f});
    std::size_t posts = 0;
    std::size_t lanterns = 0;
    for (const std::uint32_t root : night.roots) {
        posts += night.nodes[root].name == "lamp-post" ? 1 : 0;
        lanterns += night.nodes[root].name == "wall-lantern" ? 1 : 0;
    }
    EXPECT_GT(posts, 10u);
    EXPECT_GT(lanterns, 2u);
    EXPECT_EQ(lights(night, "street-lamp"), posts);
    EXPECT_EQ(lights(night, "wall-lamp"), lanterns);
    EXPECT_GT(emission(night, "street-lantern").x, 0.2f);
    EXPECT_EQ(emitters(night, "lantern-glow"), posts + lanterns);
    EXPECT_EQ(emitters(day, "lantern-glow"), 0u);
    EXPECT_GT(emitters(night, "vapour"), 0u);
    EXPECT_EQ(emitters(day, "vapour"), 0u);
    EXPECT_GT(emitters(day, "smoke"), 0u) << "somebody always cooks";
    EXPECT_GT(lights(night, "shop-lamp") + lights(night, "shop-spot"),
              lights(day, "shop-lamp") + lights(day, "shop-spot"));
    EXPECT_EQ(lights(day, "shop-window"), 0u);
    EXPECT_GT(lights(night, "shop-window"), 20u);
    for (const Light& light : night.lights) {
        // Warm: between 2000 and 4000 K, red is the most and blue the least.
        EXPECT_GT(light.colour.x, light.colour.y) << light.name;
        EXPECT_GT(light.colour.y, light.colour.z) << light.name;
    }
}

TEST(Evening, LampsOfShopWindowsLeaveTheGroundToItsLightMap) {
    const Scene night = generate_place(k_small, 1, k_night).scene;
    for (const Node& node : night.nodes) {
        if (node.light == k_none || night.lights[node.light].name != "shop-window") continue;
        const Light& light = night.lights[node.light];
        EXPECT_EQ(light.kind, LightKind::spot);
        EXPECT_LT(light.outer_cone_rad, 1.5707963f);
        const glm::vec3 aim = glm::mat3{matrix(node.local)} * glm::vec3{0, 0, -1};
        EXPECT_NEAR(aim.y, 1.0f, 1e-6f);
        EXPECT_GT(node.local.translation_m.y, 0.1f);
    }
}

TEST(Evening, SmokeRisesInTheSamePlacesAtAnyTimeAndVapourWhileLampsBurn) {
    const auto places = [](const TimeOfDay time, const std::string& name) {
        const Scene scene = generate_place("city:walkers=0,cars=0", 1, time).scene;
        std::vector<std::array<float, 3>> found;
        for (const Node& node : scene.nodes) {
            if (node.emitter == k_none || scene.emitters[node.emitter].name != name) continue;
            const glm::vec3 at =
                glm::vec3{matrix(scene.nodes[node.parent].local) * glm::vec4{node.local.translation_m, 1.0f}};
            found.push_back({at.x, at.y, at.z});
        }
        return found;
    };
    const auto by_day = places({}, "smoke");
    EXPECT_GT(by_day.size(), 5u);
    EXPECT_EQ(places(k_dusk, "smoke"), by_day);
    EXPECT_EQ(places(k_night, "smoke"), by_day);
    const auto at_dusk = places(k_dusk, "vapour");
    EXPECT_GT(at_dusk.size(), 2u);
    EXPECT_EQ(places({120}, "vapour"), at_dusk);
    EXPECT_TRUE(places({}, "vapour").empty()) << "it is warm";
}

TEST(Evening, MoreWindowsAreLitInTheEveningAndFewAtThree) {
    const Scene day = generate_place(k_small, 1).scene;
    const Scene night = generate_place(k_small, 1, k_night).scene;
    const Scene late = generate_place(k_small, 1, {3 * 60}).scene;
    const auto all = [](const Scene& scene) {
        return static_cast<double>(panes(scene, "glass") + panes(scene, "glass-lit") +
                                   panes(scene, "glass-blue"));
    };
    EXPECT_EQ(all(day), all(night)) << "what stands where does not depend on the time";
    EXPECT_EQ(all(day), all(late));
    EXPECT_EQ(panes(day, "glass-blue"), 0u);
    EXPECT_EQ(panes(day, "glass-shop-closed"), 0u);
    // 0.27 and 0.06 of some thousand windows, of three dozen independent houses: a third either way.
    EXPECT_NEAR(static_cast<double>(panes(night, "glass-lit")) / all(night), 0.27, 0.09);
    EXPECT_NEAR(static_cast<double>(panes(night, "glass-blue")) / all(night), 0.06, 0.03);
    EXPECT_LT(static_cast<double>(panes(late, "glass-lit")) / all(late), 0.08);
    EXPECT_GT(panes(night, "glass-shop-closed"), 0u);
    EXPECT_GT(panes(night, "glass-shop"), 0u);
}

TEST(Evening, TheStandardCityHasHundredsOfLamps) {
    const Scene night = generate_place("city:walkers=0,cars=0", 1, k_night).scene;
    std::size_t count = 0;
    for (const Node& node : night.nodes)
        count += node.light != k_none ? 1 : 0;
    EXPECT_GT(count, 800u);
}

}  // namespace
}  // namespace rambla::assets::test
