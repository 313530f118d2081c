#include "render/post/tonemap.h"

#include <string>

#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/tonemap.h"

namespace rambla::render {
namespace {

/// Whether a later pass smooths the tone-mapped picture on its way to the backbuffer.
bool is_smoothed(const FrameResources& resources) {
    const AntiAliasing method = resources.settings.anti_aliasing.method;
    if (method == AntiAliasing::ssaa) return resources.frame.view.samples > 1;
    return needs_display(method);
}

shared::TonemapConstants constants_of(const FrameResources& resources, bool smoothed) {
    const ToneParameters& tone = resources.settings.tone;
    return {.curve = {tone.white, tone.brightness, 1.0f / tone.gamma, tone.blue_shift},
            .target = {smoothed ? 1.0f : 0.0f, resources.exposure, 0.0f, 0.0f}};
}

}  // namespace

const gl::Program& TonemapPass::program(const Variant& v) {
    const auto curve = static_cast<std::size_t>(v.curve);
    const std::size_t switches = (v.on_luminance ? 1u : 0u) | (v.adapted ? 2u : 0u) |
                                 (v.blue_shift ? 4u : 0u) | (v.gamma ? 8u : 0u) | (v.dither ? 16u : 0u);
    const gl::Program*& program = variants_[(curve << k_switches) | switches];
    if (program == nullptr) {
        program = &programs_.get({.name = "tonemap",
                                  .vertex = "full_screen.vert.glsl",
                                  .fragment = "tonemap.frag.glsl",
                                  .compute = {},
                                  .defines = {{"CURVE", std::string{"tone_"}.append(k_tone_curves[curve])},
                                              {"ON_LUMINANCE", v.on_luminance ? "1" : "0"},
                                              {"ADAPTED", v.adapted ? "1" : "0"},
                                              {"BLUE_SHIFT", v.blue_shift ? "1" : "0"},
                                              {"GAMMA", v.gamma ? "1" : "0"},
                                              {"DITHER", v.dither ? "1" : "0"}}});
    }
    return *program;
}

void TonemapPass::add(RenderGraph& graph, FrameResources& resources) {
    const ToneParameters& tone = resources.settings.tone;
    const bool smoothed = is_smoothed(resources);
    const bool adapted = resources.adapted_exposure.valid();
    const gl::Program& curve = program({.curve = tone.curve,
                                        .on_luminance = tone.on == ToneOn::luminance,
                                        .adapted = adapted,
                                        .blue_shift = tone.blue_shift > 0.0f,
                                        .gamma = tone.gamma != 1.0f,
                                        .dither = tone.dither});
    const gl::BufferRange constants = resources.stream.upload_value(constants_of(resources, smoothed));
    graph.add_pass(
        "tonemap",
        [&](PassBuilder& pass) {
            pass.read(resources.scene_colour);
            if (adapted) pass.read(resources.adapted_exposure, graph::Use::uniform);
            if (smoothed) {
                resources.display = pass.write_colour(
                    0, pass.create_texture("display", {.format = GL_RGBA8, .size = resources.size_px()}),
                    LoadOp::discard);
            } else {
                resources.backbuffer = pass.write_colour(0, resources.backbuffer, LoadOp::discard);
            }
        },
        [&resources, &curve, constants, adapted,
         scene_colour = resources.scene_colour](PassContext& context) {
            context.bind_texture(UNIT_PASS, scene_colour, resources.samplers.nearest);
            constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            if (adapted)
                glBindBufferBase(GL_UNIFORM_BUFFER, BINDING_EXPOSURE,
                                 context.buffer(resources.adapted_exposure));
            glDisable(GL_FRAMEBUFFER_SRGB);  // the shader encodes; a window's framebuffer may be sRGB-capable
            curve.use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
