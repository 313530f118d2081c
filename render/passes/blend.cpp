#include "render/passes/blend.h"

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

BlendPass::BlendPass(gl::ProgramRegistry& programs) : programs_{programs} {
    static_cast<void>(
        program({.shadowed = true, .wide_filter = ShadowParameters{}.taps == ShadowTaps::sixteen}));
}

const gl::Program& BlendPass::program(Variant variant) {
    const std::size_t index = (variant.shadowed ? 1u : 0u) | (variant.wide_filter ? 2u : 0u) |
                              (variant.detailed ? 4u : 0u) | (variant.skinned ? 8u : 0u) |
                              (variant.morphed ? 16u : 0u);
    if (variants_[index] == nullptr) {
        variants_[index] = &programs_.get({.name = "blend",
                                           .vertex = "mesh.vert.glsl",
                                           .fragment = "blend.frag.glsl",
                                           .compute = {},
                                           .defines = {{"SHADOW_MAP", variant.shadowed ? "1" : "0"},
                                                       {"TAPS", variant.wide_filter ? "16" : "4"},
                                                       {"DETAIL", variant.detailed ? "1" : "0"},
                                                       {"EMISSION", "1"},
                                                       {"SKINNED", variant.skinned ? "1" : "0"},
                                                       {"MORPHED", variant.morphed ? "1" : "0"}}});
    }
    return *variants_[index];
}

void BlendPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.blended.empty()) return;
    const bool shadowed = resources.shadow_map.valid();
    const bool wide_filter = shadowed && resources.settings.shadows.taps == ShadowTaps::sixteen;
    graph.add_pass(
        "blend",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            if (shadowed) pass.read(resources.shadow_map);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, shadowed, wide_filter](PassContext& context) {
            if (shadowed) {
                context.bind_texture(UNIT_PASS, resources.shadow_map, resources.samplers.depth_compare);
                resources.sun_shadow.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            }
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_GREATER);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            const DrawCounts drawn = resources.blended.draw(
                resources.scene,
                [&](systems::Pipeline pipeline, std::uint32_t material) -> const gl::Program& {
                    return program({.shadowed = shadowed,
                                    .wide_filter = wide_filter,
                                    .detailed = has_detail(resources.scene.material(material)),
                                    .skinned = pipeline.skinned,
                                    .morphed = pipeline.morphed});
                });
            resources.counts.draws += drawn.draws;
            resources.counts.calls += drawn.calls;
            resources.counts.triangles += drawn.triangles;
        });
}

}  // namespace rambla::render
