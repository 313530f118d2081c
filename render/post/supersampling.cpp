#include "render/post/supersampling.h"

#include "assets/assert.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

constexpr GLint k_samples_and_dither = 0;  // location in supersampling.frag.glsl

}  // namespace

void SupersamplingPass::add(RenderGraph& graph, FrameResources& resources) {
    const std::uint32_t samples = resources.frame.view.samples;
    if (samples == 1) return;
    RAMBLA_ASSERT(resources.settings.anti_aliasing.method == AntiAliasing::ssaa,
                  "only supersampling draws more pixels than are shown");
    if (mean_ == nullptr) {
        mean_ = &programs_.get({.name = "supersampling",
                                .vertex = "full_screen.vert.glsl",
                                .fragment = "supersampling.frag.glsl",
                                .compute = {},
                                .defines = {}});
    }
    graph.add_pass(
        "supersampling",
        [&](PassBuilder& pass) {
            pass.read(resources.display);
            resources.backbuffer = pass.write_colour(0, resources.backbuffer, LoadOp::discard);
        },
        [this, &resources, samples](PassContext& context) {
            context.bind_texture(UNIT_PASS, resources.display, resources.samplers.nearest);
            glDisable(GL_FRAMEBUFFER_SRGB);  // the shader encodes
            mean_->use();
            glUniform2i(k_samples_and_dither, static_cast<GLint>(samples),
                        resources.settings.tone.dither ? 1 : 0);
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
