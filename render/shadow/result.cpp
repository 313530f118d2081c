#include "render/shadow/result.h"

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

ShadowResultPass::ShadowResultPass(gl::ProgramRegistry& programs) : programs_{programs} {
    static_cast<void>(program(ShadowParameters{}.taps, GBufferParameters{}.layout));
}

const gl::Program& ShadowResultPass::program(ShadowTaps taps, GBufferLayout layout) {
    const bool wide = taps == ShadowTaps::sixteen;
    const gl::Program*& variant = variants_[(wide ? 1u : 0u) | (layout == GBufferLayout::wide ? 2u : 0u)];
    if (variant == nullptr) {
        variant = &programs_.get(
            {.name = "shadow result",
             .vertex = "full_screen.vert.glsl",
             .fragment = "shadow_result.frag.glsl",
             .compute = {},
             .defines = {{"TAPS", wide ? "16" : "4"}, {"GBUFFER_WIDE", gbuffer_define(layout)}}});
    }
    return *variant;
}

void ShadowResultPass::add(RenderGraph& graph, FrameResources& resources) {
    const bool deferred = resources.normal.valid();  // else surfaces look the map up as they are drawn
    if (!resources.shadow_map.valid() || !deferred) return;
    const gl::Program& lookup = program(resources.settings.shadows.taps, resources.settings.gbuffer.layout);
    graph.add_pass(
        "shadow result",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            read_geometry(pass, resources);
            pass.read(resources.shadow_map);
            const TextureHandle result =
                pass.create_texture("shadow result", {.format = GL_R8, .size = resources.size_px()});
            resources.shadow_result = pass.write_colour(0, result, LoadOp::discard);
        },
        [&resources, &lookup](PassContext& context) {
            const PassSamplers& samplers = resources.samplers;
            bind_geometry(context, resources);
            context.bind_texture(UNIT_PASS + 4, resources.shadow_map, samplers.depth_compare);
            resources.sun_shadow.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_LESS);
            lookup.use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
