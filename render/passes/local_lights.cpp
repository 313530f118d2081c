#include "render/passes/local_lights.h"

#include "render/passes/light_rectangle.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

LocalLightsPass::LocalLightsPass(gl::ProgramRegistry& programs)
    : program_{programs.get({.name = "local lights",
                             .vertex = "local_lights.vert.glsl",
                             .fragment = "local_lights.frag.glsl",
                             .compute = {},
                             .defines = {}})},
      no_vertices_{"local lights"} {}

void LocalLightsPass::add(RenderGraph& graph, FrameResources& resources) {
    rectangles_.clear();
    const std::vector<systems::FrameLight>& lights = resources.frame.lights;
    for (std::uint32_t light = 0; light < lights.size(); ++light) {
        const auto r =
            sphere_rectangle(resources.frame.view, lights[light].position_m, lights[light].radius_m);
        if (!r) continue;
        rectangles_.push_back(
            {.ndc = {r->min, r->max}, .depth = r->depth, .light = light, .padding0 = 0, .padding1 = 0});
    }
    if (rectangles_.empty()) return;

    const gl::BufferRange range =
        resources.stream.upload(std::span<const shared::LightRectangle>{rectangles_});
    graph.add_pass(
        "local lights",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            for (const TextureHandle target :
                 {resources.depth, resources.albedo, resources.normal, resources.surface}) {
                pass.read(target);
            }
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, range](PassContext& context) {
            const gl::Sampler& nearest = resources.samplers.nearest;
            context.bind_texture(UNIT_PASS, resources.depth, nearest);
            context.bind_texture(UNIT_PASS + 1, resources.albedo, nearest);
            context.bind_texture(UNIT_PASS + 2, resources.normal, nearest);
            context.bind_texture(UNIT_PASS + 3, resources.surface, nearest);
            range.bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_LEQUAL);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            program_.use();
            no_vertices_.bind();
            glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(rectangles_.size()));
            ++resources.counts.draws;
            ++resources.counts.calls;
            resources.counts.triangles += 2 * rectangles_.size();
        });
}

}  // namespace rambla::render
