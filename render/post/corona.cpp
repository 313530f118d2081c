#include "render/post/corona.h"

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

void CoronaPass::add(RenderGraph& graph, FrameResources& resources) {
    const auto lights = static_cast<GLsizei>(resources.frame.lights.size());
    if (!resources.settings.bloom.corona || lights == 0 || resources.frame.view.orthographic) return;
    if (program_ == nullptr) {
        program_ = &programs_.get({.name = "corona",
                                   .vertex = "corona.vert.glsl",
                                   .fragment = "corona.frag.glsl",
                                   .compute = {},
                                   .defines = {}});
        no_vertices_.emplace("corona");
    }
    // Temporal anti-aliasing shifts the view that is drawn with, and has taken that back by now.
    const gl::BufferRange clip_from_view = resources.stream.upload_value(resources.frame.view.clip_from_view);
    graph.add_pass(
        "corona",
        [&](PassBuilder& pass) {
            pass.read(resources.depth);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, lights, clip_from_view, depth = resources.depth](PassContext& context) {
            clip_from_view.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            context.bind_texture(UNIT_PASS, depth, resources.samplers.nearest);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            no_vertices_->bind();
            program_->use();
            constexpr GLsizei k_quad_vertices = 4;
            glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, k_quad_vertices, lights);
        });
    resources.counts.draws += 1;
    resources.counts.calls += 1;
}

}  // namespace rambla::render
