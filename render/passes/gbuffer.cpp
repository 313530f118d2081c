#include "render/passes/gbuffer.h"

#include "render/passes/depth_prepass.h"

namespace rambla::render {

bool has_detail(const assets::Material& material) {
    return material.metalness_roughness_texture.texture != assets::k_none ||
           material.normal_texture.texture != assets::k_none ||
           material.occlusion_texture.texture != assets::k_none;
}

bool has_specular_textures(const assets::Material& material) {
    return material.specular_texture.texture != assets::k_none ||
           material.specular_colour_texture.texture != assets::k_none;
}

GBufferPass::GBufferPass(gl::ProgramRegistry& programs) : programs_{programs} {
    for (const bool masked : {false, true}) {
        for (const bool detailed : {false, true})
            static_cast<void>(program({.masked = masked, .detailed = detailed}));
    }
}

const gl::Program& GBufferPass::program(Variant variant) {
    const std::size_t index = (variant.masked ? 1u : 0u) | (variant.detailed ? 2u : 0u) |
                              (variant.emissive ? 4u : 0u) | (variant.skinned ? 8u : 0u) |
                              (variant.morphed ? 16u : 0u) | (variant.specular ? 32u : 0u);
    if (variants_[index] == nullptr) {
        variants_[index] = &programs_.get({.name = "gbuffer",
                                           .vertex = "mesh.vert.glsl",
                                           .fragment = "gbuffer.frag.glsl",
                                           .compute = {},
                                           .defines = {{"ALPHA_MASK", variant.masked ? "1" : "0"},
                                                       {"DETAIL", variant.detailed ? "1" : "0"},
                                                       {"EMISSION", variant.emissive ? "1" : "0"},
                                                       {"SPECULAR", variant.specular ? "1" : "0"},
                                                       {"SKINNED", variant.skinned ? "1" : "0"},
                                                       {"MORPHED", variant.morphed ? "1" : "0"}}});
    }
    return *variants_[index];
}

void GBufferPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.settings.lighting.path == LightingPath::forward) return;
    const auto target = [&](GLenum format) {
        return gl::TextureDesc{.format = format, .size = resources.size_px()};
    };
    const bool emissive = resources.frame.emissive;
    const bool depth_known = resources.depth.valid();
    graph.add_pass(
        "gbuffer",
        [&](PassBuilder& pass) {
            // Colours are read only where depth says that there is geometry.
            resources.albedo =
                pass.write_colour(0, pass.create_texture("albedo", target(GL_RGBA8)), LoadOp::discard);
            resources.normal =
                pass.write_colour(1, pass.create_texture("normal", target(GL_RG16)), LoadOp::discard);
            resources.surface =
                pass.write_colour(2, pass.create_texture("surface", target(GL_RGBA8)), LoadOp::discard);
            if (emissive) {
                resources.emission = pass.write_colour(
                    3, pass.create_texture("emission", target(GL_R11F_G11F_B10F)), LoadOp::discard);
            }
            write_or_test_depth(pass, resources);
        },
        [this, &resources, emissive, depth_known](PassContext&) {
            enable_depth(depth_known);
            resources.counts += resources.opaque.draw(
                resources.scene,
                [&](systems::Pipeline pipeline, std::uint32_t material) -> const gl::Program& {
                    return program(
                        {.masked = pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask),
                         .detailed = has_detail(resources.scene.material(material)),
                         .emissive = emissive,
                         .skinned = pipeline.skinned,
                         .morphed = pipeline.morphed,
                         .specular = has_specular_textures(resources.scene.material(material))});
                });
        });
}

}  // namespace rambla::render
