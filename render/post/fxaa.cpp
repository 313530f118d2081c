#include "render/post/fxaa.h"

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

FxaaPass::FxaaPass(gl::ProgramRegistry& programs)
    : program_{programs.get({.name = "fxaa",
                             .vertex = "full_screen.vert.glsl",
                             .fragment = "fxaa.frag.glsl",
                             .compute = {},
                             .defines = {}})} {}

void FxaaPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.settings.anti_aliasing.method != AntiAliasing::fxaa) return;
    graph.add_pass(
        "fxaa",
        [&](PassBuilder& pass) {
            pass.read(resources.display);
            resources.backbuffer = pass.write_colour(0, resources.backbuffer, LoadOp::discard);
        },
        [this, &resources](PassContext& context) {
            context.bind_texture(UNIT_PASS, resources.display, resources.samplers.linear);
            glDisable(GL_FRAMEBUFFER_SRGB);  // colours are encoded already
            program_.use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
