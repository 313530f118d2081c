#include "render/passes/sky.h"

namespace rambla::render {

SkyPass::SkyPass(gl::ProgramRegistry& programs)
    : program_{programs.get({.name = "sky",
                             .vertex = "full_screen.vert.glsl",
                             .fragment = "sky.frag.glsl",
                             .compute = {},
                             .defines = {}})} {}

void SkyPass::add(RenderGraph& graph, FrameResources& resources) {
    graph.add_pass(
        "sky",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this](PassContext& context) {
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_EQUAL);
            program_.use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
