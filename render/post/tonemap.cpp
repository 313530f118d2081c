#include "render/post/tonemap.h"

#include <string>

#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/tonemap.h"

namespace rambla::render {

TonemapPass::TonemapPass(gl::ProgramRegistry& programs) : programs_{programs} {
    static_cast<void>(program(ToneParameters{}.curve));
}

const gl::Program& TonemapPass::program(ToneCurve curve) {
    const auto index = static_cast<std::size_t>(curve);
    if (variants_[index] == nullptr) {
        variants_[index] =
            &programs_.get({.name = "tonemap",
                            .vertex = "full_screen.vert.glsl",
                            .fragment = "tonemap.frag.glsl",
                            .compute = {},
                            .defines = {{"CURVE", "tone_" + std::string{k_tone_curves[index]}}}});
    }
    return *variants_[index];
}

void TonemapPass::add(RenderGraph& graph, FrameResources& resources) {
    const bool smoothed = resources.settings.anti_aliasing.method != AntiAliasing::none;
    const gl::Program& curve = program(resources.settings.tone.curve);
    const gl::BufferRange constants = resources.stream.upload_value(
        shared::TonemapConstants{.alpha = {smoothed ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f}});
    graph.add_pass(
        "tonemap",
        [&](PassBuilder& pass) {
            pass.read(resources.scene_colour);
            if (smoothed) {
                resources.display = pass.write_colour(
                    0, pass.create_texture("display", {.format = GL_RGBA8, .size = resources.size_px()}),
                    LoadOp::discard);
            } else {
                resources.backbuffer = pass.write_colour(0, resources.backbuffer, LoadOp::discard);
            }
        },
        [&resources, &curve, constants, scene_colour = resources.scene_colour](PassContext& context) {
            context.bind_texture(UNIT_PASS, scene_colour, resources.samplers.nearest);
            constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            glDisable(GL_FRAMEBUFFER_SRGB);  // the shader encodes; a window's framebuffer may be sRGB-capable
            curve.use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
