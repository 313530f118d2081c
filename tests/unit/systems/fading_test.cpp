#include "systems/pack/fading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "assets/material.h"
#include "systems/frame.h"
#include "systems/pipeline.h"

namespace rambla::systems {
namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_inf = std::numeric_limits<float>::infinity();

TEST(Fading, OpacityBecomesTheNearestOf255Steps) {
    EXPECT_EQ(faded(1.0f), 0);
    EXPECT_EQ(faded(0.0f), k_faded_away);
    EXPECT_EQ(faded(0.5f), 128);
    EXPECT_EQ(faded(2.0f), 0);
    EXPECT_EQ(faded(k_inf), 0);
    for (const float nothing : {-1.0f, -k_inf, k_nan, 1e-30f})
        EXPECT_EQ(faded(nothing), k_faded_away) << nothing;
    for (int i = 0; i <= 255; ++i)
        EXPECT_EQ(faded(1.0f - static_cast<float>(i) / 255.0f), i);
}

TEST(Fading, NearThingsVanishEvenly) {
    const NearFade fade{0.1f, 0.5f};
    EXPECT_EQ(near_opacity(fade, 0.0f), 0.0f);
    EXPECT_EQ(near_opacity(fade, 0.1f), 0.0f);
    EXPECT_FLOAT_EQ(near_opacity(fade, 0.3f), 0.5f);
    EXPECT_EQ(near_opacity(fade, 0.5f), 1.0f);
    EXPECT_EQ(near_opacity(fade, 1e30f), 1.0f);
    EXPECT_EQ(near_opacity(fade, k_nan), 1.0f) << "what has no bounds is drawn";
    for (const NearFade& step : {NearFade{0.2f, 0.2f}, NearFade{0.2f, 0.1f}}) {
        EXPECT_EQ(near_opacity(step, 0.2f), 0.0f);
        EXPECT_EQ(near_opacity(step, std::nextafter(0.2f, 1.0f)), 1.0f);
    }
}

TEST(Fading, DistanceToABoxIsThatToItsNearestPoint) {
    const glm::vec3 half{1, 2, 3};
    EXPECT_EQ(distance_to_box({0.5f, -1, 2}, half), 0.0f) << "the eye is inside";
    EXPECT_FLOAT_EQ(distance_to_box({-4, 0, 0}, half), 3.0f);
    EXPECT_FLOAT_EQ(distance_to_box({4, 6, 0}, half), 5.0f);
    EXPECT_FLOAT_EQ(distance_to_box({3e38f, 0, 0}, half), 3e38f) << "whose square is no float";
    EXPECT_TRUE(std::isnan(distance_to_box({k_nan, 0, 0}, half)));
    EXPECT_EQ(distance_to_box({0, 0, 0}, glm::vec3{k_inf}), 0.0f);
}

struct Look {
    ecs::World world;
    Frame frame;
    Eye eye;

    Look() {
        world.set_resource(Sunlight{assets::noon()});
        eye.size_px = {64, 64};
    }

    ecs::Entity box(float z, assets::AlphaMode mode, std::uint32_t material = 0) {
        return world.create(WorldTransform{{0, 0, 0}, glm::mat3{1.0f}, {0, 0, z}},
                            Renderable{0, material, pack({.alpha = static_cast<std::uint8_t>(mode)})},
                            LocalBounds{{0, 0, 0}, glm::vec3{0.5f}});
    }
    void look() { build_frame(world, eye, 1.0f, frame); }
};

TEST(FadingQueue, WhatIsNotWholeIsBlendedAndKeepsItsShadow) {
    Look look;
    const ecs::Entity fading = look.box(-5, assets::AlphaMode::opaque);
    look.box(-6, assets::AlphaMode::opaque);
    look.world.add(fading, Opacity{0.25f});
    look.look();
    ASSERT_EQ(look.frame.opaque.size(), 1u);
    EXPECT_EQ(look.frame.opaque[0].instance_count, 1u);
    ASSERT_EQ(look.frame.blended.size(), 1u);
    EXPECT_TRUE(unpack_pipeline(look.frame.blended[0].pipeline).fading);
    const Instance& instance = look.frame.instances[look.frame.blended[0].first_instance];
    EXPECT_EQ(instance.object, fading.index);
    EXPECT_EQ(instance.material >> k_instance_fade_shift, 191u);
    ASSERT_EQ(look.frame.casters.size(), 2u);
    for (const std::uint32_t pipeline : look.frame.casters.pipeline)
        EXPECT_FALSE(unpack_pipeline(pipeline).fading);
}

TEST(FadingQueue, WholeThingsAreOpaqueAndGoneOnesOnlyCast) {
    Look look;
    const ecs::Entity thing = look.box(-5, assets::AlphaMode::mask);
    look.world.add(thing, Opacity{0.999f});
    look.look();
    EXPECT_EQ(look.frame.opaque.size(), 1u);
    EXPECT_TRUE(look.frame.blended.empty());
    look.world.get_mut<Opacity>(thing).value = 0.001f;
    look.look();
    EXPECT_TRUE(look.frame.opaque.empty());
    EXPECT_TRUE(look.frame.blended.empty());
    EXPECT_EQ(look.frame.counts.visible, 0u);
    EXPECT_EQ(look.frame.casters.size(), 1u);
    EXPECT_TRUE(look.frame.visible.empty());
}

TEST(Fading, MaterialsOfWhatMayFadeAreKnown) {
    Look look;
    for (const std::uint32_t material : {7u, 3u, 7u, 5u})
        look.world.add(look.box(-5, assets::AlphaMode::opaque, material), NearFade{});
    look.world.add(look.box(-5, assets::AlphaMode::opaque, 1), Opacity{});
    look.box(-5, assets::AlphaMode::opaque, 2);
    EXPECT_EQ(fading_materials(look.world), (std::vector<std::uint32_t>{1, 3, 5, 7}));
}

TEST(FadingQueue, GlassFadesWithoutBecomingASolid) {
    Look look;
    const ecs::Entity pane = look.box(-5, assets::AlphaMode::blend);
    look.world.add(pane, Opacity{0.5f});
    look.look();
    ASSERT_EQ(look.frame.blended.size(), 1u);
    EXPECT_FALSE(unpack_pipeline(look.frame.blended[0].pipeline).fading);
    EXPECT_EQ(look.frame.instances[0].material >> k_instance_fade_shift, 128u);
}

TEST(FadingQueue, NearThingsFadeByTheirBoxAndTheDefaultMaterialStaysItself) {
    Look look;
    const ecs::Entity walker = look.box(-0.8f, assets::AlphaMode::opaque, assets::k_none);
    look.world.add(walker, NearFade{0.1f, 0.5f});
    look.look();
    ASSERT_EQ(look.frame.blended.size(), 1u) << "its box begins 0.3 m before the eye";
    EXPECT_NEAR(look.frame.instances[0].material >> k_instance_fade_shift, 127.5, 0.6);
    EXPECT_EQ(look.frame.instances[0].material & k_instance_material_mask, k_instance_material_mask);
    look.world.add(walker, Opacity{0.5f});
    look.look();
    EXPECT_NEAR(look.frame.instances[0].material >> k_instance_fade_shift, 191.25, 0.6) << "both count";
}

}  // namespace
}  // namespace rambla::systems
