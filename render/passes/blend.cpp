#include "render/passes/blend.h"

#include <algorithm>
#include <string>

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

bool contains(const FrameResources& resources, bool systems::Pipeline::*feature) {
    return std::any_of(
        resources.frame.blended.begin(), resources.frame.blended.end(),
        [&](const systems::DrawBatch& batch) { return systems::unpack_pipeline(batch.pipeline).*feature; });
}

}  // namespace

const gl::Program& BlendPass::haze_program(const FrameResources& resources, const assets::Material& look) {
    const bool lit = look.base_colour.w > 0.0f && !look.unlit;
    const bool shadowed = lit && resources.shadow_map.valid();
    const bool wide_filter = shadowed && resources.settings.shadows.taps == ShadowTaps::sixteen;
    const auto brdf = lit ? static_cast<std::size_t>(resources.settings.brdf.model) : 0;
    const gl::Program*& variant =
        haze_[8 * brdf + (lit ? 4u : 0u) + (shadowed ? 2u : 0u) + (wide_filter ? 1u : 0u)];
    if (variant == nullptr) {
        variant = &programs_.get({.name = "haze",
                                  .vertex = "haze.vert.glsl",
                                  .fragment = "haze.frag.glsl",
                                  .compute = {},
                                  .defines = {{"LIT", lit ? "1" : "0"},
                                              {"SHADOW_MAP", shadowed ? "1" : "0"},
                                              {"TAPS", wide_filter ? "16" : "4"},
                                              {"LOCAL_LIGHTS", "LOCAL_LIGHTS_CELL"},
                                              {"BRDF", std::to_string(brdf)}}});
    }
    return *variant;
}

const gl::Program& BlendPass::surface_program(const FrameResources& resources, systems::Pipeline pipeline,
                                              const assets::Material& look) {
    const Settings& settings = resources.settings;
    const bool shadowed = resources.shadow_map.valid();
    const bool transmissive = assets::transmits(look);
    const bool masked = (transmissive || pipeline.fading) && look.alpha_mode == assets::AlphaMode::mask;
    return surfaces_.get({.blended = true,
                          .masked = masked,
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
}

void BlendPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.blended.empty()) return;
    const bool shadowed = resources.shadow_map.valid();
    const bool fading = contains(resources, &systems::Pipeline::fading);
    const bool haze = contains(resources, &systems::Pipeline::haze);
    graph.add_pass(
        "blend",
        [&](PassBuilder& pass) {
            if (haze) pass.read(resources.depth);
            if (fading) {
                resources.depth = pass.write_depth(resources.depth, LoadOp::load);
            } else {
                pass.test_depth(resources.depth);
            }
            if (shadowed) pass.read(resources.shadow_map);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, shadowed, fading, haze](PassContext& context) {
            if (shadowed) {
                context.bind_texture(UNIT_BESIDE_MATERIALS, resources.shadow_map,
                                     resources.samplers.depth_compare);
                resources.sun_shadow.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            }
            if (haze)
                context.bind_texture(UNIT_BESIDE_MATERIALS + 1, resources.depth, resources.samplers.nearest);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_GREATER);
            glEnable(GL_BLEND);
            // Of the one target alone: a second source for others, even absent ones, is more than OpenGL
            // promises.
            glBlendFunci(0, GL_ONE, GL_SRC1_COLOR);
            resources.counts += resources.blended.draw(
                resources.scene,
                [&](systems::Pipeline pipeline, std::uint32_t material) -> const gl::Program& {
                    const assets::Material& look = resources.scene.material(material);
                    if (!pipeline.haze) return surface_program(resources, pipeline, look);
                    if (fading) glTextureBarrier();  // haze reads what fading things before it have written
                    return haze_program(resources, look);
                });
        });
}

}  // namespace rambla::render
