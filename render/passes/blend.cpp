#include "render/passes/blend.h"

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

void BlendPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.blended.empty()) return;
    const bool shadowed = resources.shadow_map.valid();
    graph.add_pass(
        "blend",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            if (shadowed) pass.read(resources.shadow_map);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, shadowed](PassContext& context) {
            if (shadowed) {
                context.bind_texture(UNIT_BESIDE_MATERIALS, resources.shadow_map,
                                     resources.samplers.depth_compare);
                resources.sun_shadow.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            }
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_GREATER);
            glEnable(GL_BLEND);
            // Of the one target alone: a second source for others, even absent ones, is more than OpenGL
            // promises.
            glBlendFunci(0, GL_ONE, GL_SRC1_COLOR);
            const Settings& settings = resources.settings;
            resources.counts += resources.blended.draw(
                resources.scene,
                [&](systems::Pipeline pipeline, std::uint32_t material) -> const gl::Program& {
                    const assets::Material& look = resources.scene.material(material);
                    const bool transmissive = assets::transmits(look);
                    return programs_.get(
                        {.blended = true,
                         .masked = transmissive && look.alpha_mode == assets::AlphaMode::mask,
                         .detail = surface_detail(look, settings.detail.grade),
                         .emissive = true,
                         .skinned = pipeline.skinned,
                         .morphed = pipeline.morphed,
                         .shadowed = shadowed,
                         .wide_filter = shadowed && settings.shadows.taps == ShadowTaps::sixteen,
                         .specular = has_specular_textures(look),
                         .transmissive = transmissive,
                         .light_mapped = assets::is_light_mapped(look),
                         .brdf = settings.brdf.model});
                });
        });
}

}  // namespace rambla::render
