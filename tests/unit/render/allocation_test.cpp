#include <gtest/gtest.h>

#include "render/renderer.h"
#include "support/allocation_counter.h"
#include "support/quick_process.h"

namespace rambla::render {
namespace {

/// One white triangle before the eye, under a sun that makes it throw a shadow, beside a lamp.
FrameInput one_triangle() {
    FrameInput input;
    systems::Frame& frame = input.frame;
    frame.view.size_px = {64, 32};
    frame.view.clip_from_view = glm::mat4{0.0f};
    frame.view.clip_from_view[0].x = 0.5f;
    frame.view.clip_from_view[1].y = 1.0f;
    frame.view.clip_from_view[2].w = -1.0f;
    frame.view.clip_from_view[3].z = 0.1f;
    frame.environment = assets::noon();
    frame.instances.push_back({.row2 = {0.0f, 0.0f, 1.0f, -3.0f}, .material = 0});
    frame.opaque.push_back(
        {.pipeline = systems::pack({}), .material = 0, .mesh = 0, .first_instance = 0, .instance_count = 1});
    frame.visible = {{-1.0f, -1.0f, -3.0f}, {1.0f, 1.0f, -3.0f}};
    frame.lights.push_back(
        {.position_m = {0.0f, 0.0f, -2.0f}, .radius_m = 5.0f, .intensity = glm::vec3{1.0f}});
    systems::CasterColumns& casters = frame.casters;
    for (auto* column : {&casters.centre_x, &casters.centre_y})
        column->push_back(0.0f);
    casters.centre_z.push_back(-3.0f);
    for (auto* column : {&casters.half_x, &casters.half_y, &casters.half_z})
        column->push_back(1.0f);
    for (auto* column : {&casters.pipeline, &casters.material, &casters.mesh, &casters.instance}) {
        column->push_back(0);
    }
    return input;
}

assets::Scene one_mesh() {
    assets::Scene scene;
    assets::Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-1.0f, -1.0f, 0.0f}, {1.0f, -1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    mesh.indices = {0, 1, 2};
    for (const glm::vec3& position : mesh.positions)
        mesh.bounds.expand(position);
    scene.materials.emplace_back();
    return scene;
}

TEST(Renderer, AllocatesNothingInASteadyFrame) {
    RenderThreadOptions options;
    options.compile_ahead = false;
    Renderer renderer{options};
    const assets::Scene scene = one_mesh();
    renderer.upload(scene, *tests::quick_process(scene));
    FrameInput input = one_triangle();
    for (const LightingPath path : {LightingPath::tiled, LightingPath::volumes}) {
        input.settings.lighting.path = path;
        input.settings.lighting.volume = LightVolume::solid;
        std::vector<FrameOutput> outputs;
        std::size_t last = 1;
        for (int frame = 0; frame < 12; ++frame) {
            const std::size_t before = test::allocation_count_of_this_thread();
            renderer.draw(input);
            last = test::allocation_count_of_this_thread() - before;
            renderer.take_finished(outputs, true);  // the outputs are the caller's, and so is their memory
        }
        EXPECT_EQ(last, 0u) << static_cast<int>(path);
        ASSERT_EQ(outputs.size(), 12u);
        EXPECT_GE(outputs.back().feedback.draws, 2u) << "the triangle was drawn, and its shadow";
        EXPECT_GE(outputs.back().feedback.triangles, 2u);
    }
}

TEST(Renderer, AllocatesNothingWhileItFollowsWhatMoves) {
    RenderThreadOptions options;
    options.compile_ahead = false;
    Renderer renderer{options};
    const assets::Scene scene = one_mesh();
    renderer.upload(scene, *tests::quick_process(scene));
    FrameInput input = one_triangle();
    input.settings.anti_aliasing.method = AntiAliasing::taa;
    std::vector<FrameOutput> outputs;
    std::size_t last = 1;
    for (int frame = 0; frame < 12; ++frame) {
        input.frame.instances[0].row0.w = 0.1f * static_cast<float>(frame % 2);
        const std::size_t before = test::allocation_count_of_this_thread();
        renderer.draw(input);
        last = test::allocation_count_of_this_thread() - before;
        renderer.take_finished(outputs, true);
    }
    EXPECT_EQ(last, 0u);
    EXPECT_GE(outputs.back().feedback.draws, 3u) << "the triangle, its shadow and its motion";
}

}  // namespace
}  // namespace rambla::render
