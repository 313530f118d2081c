#include "game/study/frame_tracer.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "game/camera_path.h"
#include "game/model_view.h"
#include "study/drawn_and_traced.h"

namespace rambla::game::study::test {
namespace {

/// Of pixels beside silhouettes. What is left are surfaces that lie in one another, masks whose mip level the
/// rasteriser chooses for four pixels at once, and silhouettes between parts of one object.
constexpr double k_allowed_pct = 0.1;

Drawer& drawer() {
    static Drawer one;
    return one;
}

/// Draws and traces what an eye sees.
Agreement compare(const systems::Eye& eye) {
    const render::ObjectImage drawn = drawer().draw(eye);
    const FrameTracer tracer = drawer().tracer();
    const Agreement found =
        agreement(object_ids(assets::trace_picture(tracer.tracer(), tracer.camera())), drawn);
    ::testing::Test::RecordProperty("wrong_inside_pct", std::to_string(found.wrong_inside_pct()));
    std::printf("  %zu of %zu pixels inside (%.1f %%), %zu objects; wrong: %zu (%.4f %%), of all %.3f %%\n",
                found.inside, found.pixels, found.inside_pct(), found.objects, found.wrong_inside,
                found.wrong_inside_pct(), found.wrong_pct());
    return found;
}

void expect_agreement(const systems::Eye& eye, std::size_t least_objects) {
    const Agreement found = compare(eye);
    EXPECT_LE(found.wrong_inside_pct(), k_allowed_pct)
        << "first at " << found.first_wrong.x << ", " << found.first_wrong.y;
    EXPECT_GE(found.objects, least_objects);
    EXPECT_GE(found.inside_pct(), 40.0) << "enough is compared";
}

void compare_walk(const std::string& scene, assets::TimeOfDay time, float share, std::size_t least_objects) {
    Stage stage = make_stage(scene, 1, time, {});
    drawer().show(stage);
    for (int i = 0; i < 90; ++i)
        systems::step(*stage.world);
    systems::Eye eye = walk_eye(stage, share * duration_s(stage.walk));
    eye.size_px = {640, 360};
    expect_agreement(eye, least_objects);
}

TEST(FrameTracer, SeesWhatTheRendererDrawsInTheStreetAtNoon) {
    compare_walk("street", {}, 0.2f, 60);
}

TEST(FrameTracer, SeesWhatTheRendererDrawsInTheStreetAtNight) {
    compare_walk("street", assets::k_night, 0.7f, 60);
}

TEST(FrameTracer, SeesWhatTheRendererDrawsInAnotherTown) {
    compare_walk("city:blocks=2x2,walkers=60,cars=10", assets::k_dusk, 0.5f, 30);
}

TEST(FrameTracer, SeesWhatTheRendererDrawsOfBlocks) {
    compare_walk("blocks", {}, 0.4f, 100);
}

TEST(FrameTracer, SeesWhatTheRendererDrawsOfAgents) {
    compare_walk("agents", {}, 0.4f, 20);
}

/// Files that bend, morph, mirror and cut out.
class FrameTracerOnFiles : public ::testing::TestWithParam<const char*> {};

TEST_P(FrameTracerOnFiles, SeesWhatTheRendererDraws) {
    const std::filesystem::path file = std::filesystem::path{RAMBLA_GLTF_DIR} / GetParam();
    ASSERT_TRUE(std::filesystem::exists(file)) << "RAMBLA_GLTF_DIR has no " << GetParam();
    ViewWishes wishes;
    wishes.size_px = {480, 360};
    ModelView view = view_model(file, wishes);
    const bool moves = view.stage.player != ecs::Entity{};
    if (moves) {
        wishes.clip_time_s = 0.4;
        view = view_model(file, wishes);
    }
    drawer().show(view.stage);
    expect_agreement(view.eye, 2);
    if (moves) {
        bool deforms = false;
        for (const systems::DrawBatch& batch : drawer().frame().opaque) {
            const systems::Pipeline pipeline = systems::unpack_pipeline(batch.pipeline);
            deforms = deforms || pipeline.skinned || pipeline.morphed;
        }
        EXPECT_TRUE(deforms);
    }
}

// ./test leaves GltfCorpus out, and says so, where there are no sample files.
INSTANTIATE_TEST_SUITE_P(GltfCorpus, FrameTracerOnFiles,
                         ::testing::Values("models/Fox/glTF-Binary/Fox.glb",
                                           "models/MorphStressTest/glTF-Binary/MorphStressTest.glb",
                                           "models/AnimatedMorphCube/glTF-Binary/AnimatedMorphCube.glb",
                                           "models/AlphaBlendModeTest/glTF-Binary/AlphaBlendModeTest.glb",
                                           "models/TextureEncodingTest/glTF-Binary/TextureEncodingTest.glb",
                                           "models/NegativeScaleTest/glTF-Binary/NegativeScaleTest.glb",
                                           "scenes/LittlestTokyo/LittlestTokyo.gltf"));

}  // namespace
}  // namespace rambla::game::study::test
