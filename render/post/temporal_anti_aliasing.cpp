#include "render/post/temporal_anti_aliasing.h"

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

const gl::Program& TemporalAntiAliasingPass::program(bool reproject, bool motion, bool clamp) {
    const std::size_t index = (reproject ? 1u : 0u) | (motion ? 2u : 0u) | (clamp ? 4u : 0u);
    if (variants_[index] == nullptr) {
        variants_[index] = &programs_.get({.name = "temporal anti-aliasing",
                                           .vertex = "full_screen.vert.glsl",
                                           .fragment = "temporal_anti_aliasing.frag.glsl",
                                           .compute = {},
                                           .defines = {{"REPROJECT", reproject ? "1" : "0"},
                                                       {"MOTION", motion ? "1" : "0"},
                                                       {"CLAMP", clamp ? "1" : "0"}}});
    }
    return *variants_[index];
}

void TemporalAntiAliasingPass::add(RenderGraph& graph, FrameResources& resources) {
    const TemporalFrame* const temporal = resources.temporal;
    if (temporal == nullptr) {
        histories_ = {};
        return;
    }
    const gl::TextureDesc desc{.format = GL_RGBA16F, .size = resources.size_px()};
    if (!histories_[0] || histories_[0].desc() != desc)
        histories_ = {gl::Texture{"history", desc}, gl::Texture{"history", desc}};
    const TextureHandle then = graph.import_texture("history", histories_[latest_], false);
    latest_ = 1 - latest_;
    TextureHandle now = graph.import_texture("new history", histories_[latest_], true);

    const bool motion = resources.motion.valid();
    const bool reproject = temporal->camera_moved || !temporal->has_past;
    const gl::Program& resolve = program(reproject, motion, resources.settings.anti_aliasing.clamp);
    const TextureHandle jittered = resources.scene_colour;
    const GLenum format = graph.desc(jittered).format;
    graph.add_pass(
        "temporal anti-aliasing",
        [&](PassBuilder& pass) {
            pass.read(jittered);
            pass.read(then);
            pass.read(resources.depth);
            if (motion) pass.read(resources.motion);
            now = pass.write_colour(0, now, LoadOp::discard);
            resources.scene_colour = pass.write_colour(
                1, pass.create_texture("scene colour", {.format = format, .size = resources.size_px()}),
                LoadOp::discard);
        },
        [&resources, &resolve, jittered, then, motion](PassContext& context) {
            const PassSamplers& samplers = resources.samplers;
            context.bind_texture(UNIT_PASS, jittered, samplers.nearest);
            context.bind_texture(UNIT_PASS + 1, then, samplers.linear);
            context.bind_texture(UNIT_PASS + 2, resources.depth, samplers.nearest);
            if (motion) context.bind_texture(UNIT_PASS + 3, resources.motion, samplers.nearest);
            resources.temporal_constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            resolve.use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
