#include <gtest/gtest.h>

#include "game/study/deformed_mesh.h"
#include "game/study/frame_tracer.h"
#include "study/drawn_and_traced.h"

namespace rambla::game::study::test {
namespace {

/// A Frame of squares that face the eye, one behind the other.
struct Squares {
    Squares() {
        assets::ProcessedMesh square;
        square.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        square.mesh.normals.assign(4, {0, 0, 1});
        square.mesh.indices = {0, 1, 2, 0, 2, 3};
        processed.meshes.push_back(square);
        frame.view.size_px = {1, 1};
        frame.view.clip_from_view = glm::mat4{0.0f};
        frame.view.clip_from_view[0][0] = frame.view.clip_from_view[1][1] = 1.0f;
        frame.view.clip_from_view[2][3] = -1.0f;
        frame.view.clip_from_view[3][2] = 0.05f;
    }

    std::uint32_t instance(float z) {
        const auto number = static_cast<std::uint32_t>(frame.instances.size());
        frame.instances.push_back({.row2 = {0, 0, 1, z}, .material = assets::k_none, .object = 100 + number});
        return number;
    }
    void draw(std::uint32_t number, systems::Pipeline pipeline = {}) {
        frame.opaque.push_back({systems::pack(pipeline), assets::k_none, 0, number, 1});
    }
    void cast(std::uint32_t number, systems::Pipeline pipeline = {}) {
        frame.casters.pipeline.push_back(systems::pack(pipeline));
        frame.casters.material.push_back(assets::k_none);
        frame.casters.mesh.push_back(0);
        frame.casters.instance.push_back(number);
    }
    [[nodiscard]] std::uint32_t object_at(double t_min, std::uint32_t rays) const {
        const FrameTracer traced{frame, scene, processed};
        const auto hit = traced.tracer().first_hit({.origin_m = {0.1, 0.2, 0}, .t_min = t_min, .rays = rays});
        return hit ? hit->object : assets::k_none;
    }

    assets::Scene scene;
    assets::ProcessedScene processed;
    systems::Frame frame;
};

TEST(PackedFrame, SightMeetsWhatIsDrawnAndLightWhatCasts) {
    Squares s;
    s.cast(s.instance(-1));
    s.draw(s.instance(-2));
    const std::uint32_t both = s.instance(-3);
    s.draw(both);
    s.cast(both);
    EXPECT_EQ(s.object_at(0.0, assets::k_rays_of_sight), 101u);
    EXPECT_EQ(s.object_at(2.5, assets::k_rays_of_sight), 102u);
    EXPECT_EQ(s.object_at(0.0, assets::k_rays_of_light), 100u);
    EXPECT_EQ(s.object_at(1.5, assets::k_rays_of_light), 102u);
    EXPECT_EQ(s.object_at(1.5, assets::k_rays_of_all), 101u);
    const FrameTracer traced{s.frame, s.scene, s.processed};
    EXPECT_EQ(traced.tracer().scene().instances.size(), 3u);
    EXPECT_EQ(object_ids(assets::trace_picture(traced.tracer(), traced.camera())),
              std::vector<std::uint32_t>{101});
}

TEST(PackedFrame, WhatBlendsIsNotSeenButMayCast) {
    Squares s;
    const std::uint32_t fading = s.instance(-1);
    s.frame.blended.push_back({systems::pack({.fading = true}), assets::k_none, 0, fading, 1});
    s.cast(fading);
    s.draw(s.instance(-2));
    EXPECT_EQ(s.object_at(0.0, assets::k_rays_of_sight), 101u);
    EXPECT_EQ(s.object_at(0.0, assets::k_rays_of_light), 100u);
}

TEST(PackedFrame, LinesAndPointsAreLeftOut) {
    Squares s;
    s.draw(s.instance(-1), {.topology = static_cast<std::uint8_t>(assets::Topology::lines)});
    s.draw(s.instance(-2), {.topology = static_cast<std::uint8_t>(assets::Topology::points)});
    EXPECT_EQ(s.object_at(0.0, assets::k_rays_of_all), assets::k_none);
}

TEST(PackedFrame, FrontsAreThoseOfThePipeline) {
    Squares s;
    s.draw(s.instance(-1), {.mirrored = true});  // as if its map mirrored: it shows its back
    s.draw(s.instance(-2));
    EXPECT_EQ(s.object_at(0.0, assets::k_rays_of_sight), 101u);
    s.frame.opaque[0].pipeline = systems::pack({.double_sided = true, .mirrored = true});
    EXPECT_EQ(s.object_at(0.0, assets::k_rays_of_sight), 100u);
}

TEST(PackedFrame, MorphsComeBeforeSkins) {
    Squares s;
    assets::Mesh& mesh = s.processed.meshes[0].mesh;
    mesh.morphs.resize(1);
    mesh.morphs[0].positions.assign(4, {0, 0, 3});
    mesh.morphs[0].normals.assign(4, {0, 2, 0});
    mesh.joints.assign(4, {0, 1, 0, 0});
    mesh.weights.assign(4, {0.75f, 0.25f, 0, 0});
    // Joint 0 doubles z, joint 1 moves by 4: the mean scales z by 1.75 and moves by 1.
    s.frame.joints = {{}, {.row2 = {0, 0, 2, 0}}, {.row2 = {0, 0, 1, -4}}};
    s.frame.morphs = {{}, {0, -0.5f}, {}};
    const systems::Instance instance{.joints = 1, .morphs = 1};
    const auto targets = morph_targets(s.processed);
    const DeformedMesh moved = deformed(mesh, instance, {.skinned = true, .morphed = true}, s.frame, targets);
    EXPECT_NEAR(moved.positions[0].z, 1.75f * -1.5f - 1.0f, 1e-4f);  // weights have 16 bits
    // The normal (0, −1, 1) by the inverse transpose: (0, −1, 1/1.75).
    EXPECT_NEAR(moved.normals[0].z / -moved.normals[0].y, 1.0f / 1.75f, 1e-4f);
    EXPECT_NEAR(glm::length(moved.normals[0]), 1.0f, 1e-6f);
    s.frame.instances.push_back(instance);
    s.draw(0, {.skinned = true, .morphed = true});
    const FrameTracer traced{s.frame, s.scene, s.processed};
    const auto hit = traced.tracer().first_hit({.origin_m = {0.1, 0.2, 0}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance_m, 1.75 * 1.5 + 1.0, 1e-4);
}

TEST(ObjectAgreement, SeesOnePixelThatIsWrong) {
    std::vector<std::uint32_t> traced(64, 3);
    for (std::size_t i = 0; i < traced.size(); ++i)
        traced[i] = i % 8 < 4 ? 3 : 5;
    render::ObjectImage drawn{8, 8, traced};
    Agreement found = agreement(traced, drawn);
    EXPECT_EQ(found.inside, 24u) << "neither at the rim nor beside the edge";
    EXPECT_EQ(found.objects, 2u);
    EXPECT_EQ(found.wrong_inside, 0u);
    drawn.ids[8 * 3 + 2] = 5;
    drawn.ids[8 * 3 + 4] = 3;
    found = agreement(traced, drawn);
    EXPECT_EQ(found.wrong, 2u);
    EXPECT_EQ(found.wrong_inside, 1u) << "the other lies on the edge";
    EXPECT_EQ(found.first_wrong, (glm::uvec2{2, 3}));
}

}  // namespace
}  // namespace rambla::game::study::test
