#include "render/passes/forward.h"

#include "render/passes/depth_prepass.h"
#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

void ForwardPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.settings.lighting.path != LightingPath::forward) return;
    const bool shadowed = resources.shadow_map.valid();
    const bool depth_known = resources.depth.valid();
    graph.add_pass(
        "forward",
        [&](PassBuilder& pass) {
            if (shadowed) pass.read(resources.shadow_map);
            const TextureHandle colour = pass.create_texture(
                "scene colour",
                {.format = scene_colour_format(resources.settings.tone), .size = resources.size_px()});
            resources.scene_colour = pass.write_colour(0, colour, LoadOp::discard);
            write_or_test_depth(pass, resources);
        },
        [this, &resources, shadowed, depth_known](PassContext& context) {
            if (shadowed) {
                context.bind_texture(UNIT_BESIDE_MATERIALS, resources.shadow_map,
                                     resources.samplers.depth_compare);
                resources.sun_shadow.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            }
            enable_depth(depth_known);
            const Settings& settings = resources.settings;
            resources.counts += resources.opaque.draw(
                resources.scene,
                [&](systems::Pipeline pipeline, std::uint32_t material) -> const gl::Program& {
                    const assets::Material& look = resources.scene.material(material);
                    const bool emissive = resources.frame.needs_emission;
                    return programs_.get(
                        {.masked = pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask),
                         .detail = surface_detail(look, settings.detail.grade),
                         .emissive = emissive,
                         .skinned = pipeline.skinned,
                         .morphed = pipeline.morphed,
                         .shadowed = shadowed,
                         .wide_filter = shadowed && settings.shadows.taps == ShadowTaps::sixteen,
                         .specular = has_specular_textures(look),
                         .light_mapped = emissive && assets::is_light_mapped(look),
                         .brdf = settings.brdf.model});
                });
        });
}

}  // namespace rambla::render
