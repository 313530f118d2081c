#include "render/passes/lighting.h"

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

LightingPass::LightingPass(gl::ProgramRegistry& programs) : programs_{programs} {
    static_cast<void>(program(true, false));
}

const gl::Program& LightingPass::program(bool shadowed, bool emissive) {
    const gl::Program*& variant = variants_[(shadowed ? 1u : 0u) | (emissive ? 2u : 0u)];
    if (variant == nullptr) {
        variant = &programs_.get(
            {.name = "lighting",
             .vertex = "full_screen.vert.glsl",
             .fragment = "lighting.frag.glsl",
             .compute = {},
             .defines = {{"SHADOW_RESULT", shadowed ? "1" : "0"}, {"EMISSION", emissive ? "1" : "0"}}});
    }
    return *variant;
}

void LightingPass::add(RenderGraph& graph, FrameResources& resources) {
    const bool shadowed = resources.shadow_result.valid();
    const bool emissive = resources.emission.valid();
    const gl::Program& light = program(shadowed, emissive);
    graph.add_pass(
        "lighting",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            for (const TextureHandle target :
                 {resources.depth, resources.albedo, resources.normal, resources.surface}) {
                pass.read(target);
            }
            if (shadowed) pass.read(resources.shadow_result);
            if (emissive) pass.read(resources.emission);
            const TextureHandle colour =
                pass.create_texture("scene colour", {.format = GL_RGBA16F, .size = resources.size_px()});
            resources.scene_colour = pass.write_colour(0, colour, LoadOp::discard);
        },
        [&resources, &light, shadowed, emissive](PassContext& context) {
            const gl::Sampler& nearest = resources.samplers.nearest;
            context.bind_texture(UNIT_PASS, resources.depth, nearest);
            context.bind_texture(UNIT_PASS + 1, resources.albedo, nearest);
            context.bind_texture(UNIT_PASS + 2, resources.normal, nearest);
            context.bind_texture(UNIT_PASS + 3, resources.surface, nearest);
            if (shadowed) context.bind_texture(UNIT_PASS + 4, resources.shadow_result, nearest);
            if (emissive) context.bind_texture(UNIT_PASS + 5, resources.emission, nearest);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_LESS);
            light.use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
