#include "render/passes/light_volumes.h"

#include <algorithm>
#include <string>

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

/// Of what lies that far before the eye; 1 where that is nearer than the near plane.
float depth_at(const systems::FrameView& view, float distance_m) {
    const glm::mat4& p = view.clip_from_view;
    if (view.orthographic) return std::clamp(p[3][2] - p[2][2] * distance_m, 0.0f, 1.0f);
    const float near_m = p[3][2];
    return distance_m > near_m ? near_m / distance_m : 1.0f;
}

}  // namespace

LightVolumesPass::LightVolumesPass(gl::ProgramRegistry& programs)
    : programs_{programs}, no_vertices_{"light volumes"} {}

const gl::Program& LightVolumesPass::program(Brdf brdf, GBufferLayout layout) {
    const gl::Program*& variant = variants_[static_cast<std::size_t>(brdf) * k_gbuffer_layouts.size() +
                                            static_cast<std::size_t>(layout)];
    if (variant == nullptr) {
        variant = &programs_.get({.name = "light volume",
                                  .vertex = "light_volume.vert.glsl",
                                  .fragment = "light_volume.frag.glsl",
                                  .compute = {},
                                  .defines = {{"NEAR_SIDE", "0"},
                                              {"MEETS_SKY", "0"},
                                              {"GBUFFER_WIDE", gbuffer_define(layout)},
                                              {"BRDF", std::to_string(static_cast<int>(brdf))}}});
    }
    return *variant;
}

const gl::Program& LightVolumesPass::tester() {
    if (tester_ == nullptr) {
        tester_ = &programs_.get({.name = "light test",
                                  .vertex = "light_volume.vert.glsl",
                                  .fragment = {},
                                  .compute = {},
                                  .defines = {{"NEAR_SIDE", "1"}}});
    }
    return *tester_;
}

void LightVolumesPass::make_rectangles(const FrameResources& resources) {
    rectangles_.clear();
    for (const BoundedLight& light : resources.bounded_lights) {
        const ScreenRectangle& bounds = light.bounds;
        rectangles_.push_back({.ndc = {bounds.min, bounds.max},
                               .depth = bounds.depth,
                               .light = light.light,
                               .near_depth = depth_at(resources.view, bounds.nearest_m),
                               .padding0 = 0});
    }
}

void LightVolumesPass::add(RenderGraph& graph, FrameResources& resources) {
    const LightingParameters& parameters = resources.settings.lighting;
    if (parameters.path != LightingPath::volumes || parameters.volume != LightVolume::quad) return;
    if (resources.bounded_lights.empty()) return;
    make_rectangles(resources);
    const gl::Program& light = program(resources.settings.brdf.model, resources.settings.gbuffer.layout);
    if (parameters.queries) static_cast<void>(tester());
    const gl::BufferRange range =
        resources.stream.upload(std::span<const shared::LightRectangle>{rectangles_});
    graph.add_pass(
        "light volumes",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            read_gbuffer(pass, resources);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, &light, range, queries = parameters.queries](PassContext& context) {
            bind_gbuffer(context, resources);
            range.bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE);
            no_vertices_.bind();
            glEnable(GL_DEPTH_TEST);
            if (queries) test_each();
            glDepthFunc(GL_LEQUAL);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            light.use();
            const auto count = static_cast<std::uint32_t>(rectangles_.size());
            if (queries) {
                draw_each();
            } else {
                glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
            }
            resources.counts.draws += queries ? 2 * count : 1;
            resources.counts.calls += queries ? 2 * count : 1;
            resources.counts.triangles += 2 * std::uint64_t{count};
        });
}

void LightVolumesPass::test_each() {
    while (queries_.size() < rectangles_.size())
        queries_.emplace_back("light", GL_ANY_SAMPLES_PASSED);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_GREATER);
    tester_->use();
    for (GLuint light = 0; light < rectangles_.size(); ++light) {
        glBeginQuery(GL_ANY_SAMPLES_PASSED, queries_[light].name());
        glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, 1, light);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void LightVolumesPass::draw_each() {
    for (GLuint light = 0; light < rectangles_.size(); ++light) {
        glBeginConditionalRender(queries_[light].name(), GL_QUERY_WAIT);
        glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, 1, light);
        glEndConditionalRender();
    }
}

}  // namespace rambla::render
