#include "render/passes/gbuffer.h"

#include "render/passes/depth_prepass.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

bool has_specular_textures(const assets::Material& material) {
    return material.specular_texture.texture != assets::k_none ||
           material.specular_colour_texture.texture != assets::k_none;
}

std::string gbuffer_define(GBufferLayout layout) {
    return layout == GBufferLayout::wide ? "1" : "0";
}

void read_geometry(PassBuilder& pass, const FrameResources& resources) {
    pass.read(resources.depth);
    pass.read(resources.normal);
    if (!resources.position.valid()) return;
    pass.read(resources.albedo);  // for what the wide layout keeps beside the colour
    pass.read(resources.position);
    pass.read(resources.tangent);
}

void bind_geometry(const PassContext& context, const FrameResources& resources) {
    const gl::Sampler& nearest = resources.samplers.nearest;
    context.bind_texture(UNIT_PASS, resources.depth, nearest);
    context.bind_texture(UNIT_PASS + 2, resources.normal, nearest);
    if (!resources.position.valid()) return;
    context.bind_texture(UNIT_PASS + 1, resources.albedo, nearest);
    context.bind_texture(UNIT_PASS + 6, resources.position, nearest);
    context.bind_texture(UNIT_PASS + 7, resources.tangent, nearest);
}

void read_gbuffer(PassBuilder& pass, const FrameResources& resources) {
    read_geometry(pass, resources);
    if (!resources.position.valid()) pass.read(resources.albedo);
    pass.read(resources.surface);
}

void bind_gbuffer(const PassContext& context, const FrameResources& resources) {
    bind_geometry(context, resources);
    context.bind_texture(UNIT_PASS + 1, resources.albedo, resources.samplers.nearest);
    context.bind_texture(UNIT_PASS + 3, resources.surface, resources.samplers.nearest);
}

const gl::Program& GBufferPass::program(Variant variant) {
    const std::size_t index =
        (variant.masked ? 1u : 0u) | (variant.emissive ? 2u : 0u) | (variant.skinned ? 4u : 0u) |
        (variant.morphed ? 8u : 0u) | (variant.specular ? 16u : 0u) |
        (variant.layout == GBufferLayout::wide ? 32u : 0u) | (variant.light_mapped ? 64u : 0u) |
        static_cast<std::size_t>(variant.detail) << 7u;
    if (variants_[index] == nullptr) {
        variants_[index] = &programs_.get({.name = "gbuffer",
                                           .vertex = "mesh.vert.glsl",
                                           .fragment = "gbuffer.frag.glsl",
                                           .compute = {},
                                           .defines = {{"ALPHA_MASK", variant.masked ? "1" : "0"},
                                                       {"DETAIL", detail_define(variant.detail)},
                                                       {"EMISSION", variant.emissive ? "1" : "0"},
                                                       {"SPECULAR", variant.specular ? "1" : "0"},
                                                       {"TRANSMISSION", "0"},
                                                       {"LIGHT_MAP", variant.light_mapped ? "1" : "0"},
                                                       {"GBUFFER_WIDE", gbuffer_define(variant.layout)},
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
    const bool emissive = resources.frame.needs_emission;
    const GBufferLayout layout = resources.settings.gbuffer.layout;
    const bool wide = layout == GBufferLayout::wide;
    const bool depth_known = resources.depth.valid();
    graph.add_pass(
        "gbuffer",
        [&](PassBuilder& pass) {
            // Colours are read only where depth says that there is geometry.
            resources.albedo = pass.write_colour(
                0, pass.create_texture("albedo", target(wide ? GL_RGBA16F : GL_RGBA8)), LoadOp::discard);
            resources.normal = pass.write_colour(
                1, pass.create_texture("normal", target(wide ? GL_RGBA16F : GL_RG16)), LoadOp::discard);
            resources.surface =
                pass.write_colour(2, pass.create_texture("surface", target(GL_RGBA8)), LoadOp::discard);
            if (emissive) {
                resources.emission = pass.write_colour(
                    3, pass.create_texture("emission", target(GL_R11F_G11F_B10F)), LoadOp::discard);
            }
            if (wide) {
                resources.position = pass.write_colour(4, pass.create_texture("position", target(GL_RGBA16F)),
                                                       LoadOp::discard);
                resources.tangent =
                    pass.write_colour(5, pass.create_texture("tangent", target(GL_RGBA16F)), LoadOp::discard);
            }
            write_or_test_depth(pass, resources);
        },
        [this, &resources, emissive, layout, depth_known](PassContext&) {
            enable_depth(depth_known);
            resources.counts += resources.opaque.draw(
                resources.scene,
                [&](systems::Pipeline pipeline, std::uint32_t material) -> const gl::Program& {
                    const assets::Material& look = resources.scene.material(material);
                    return program(
                        {.masked = pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask),
                         .detail = surface_detail(look, resources.settings.detail.grade),
                         .emissive = emissive,
                         .skinned = pipeline.skinned,
                         .morphed = pipeline.morphed,
                         .specular = has_specular_textures(look),
                         .light_mapped = emissive && assets::is_light_mapped(look),
                         .layout = layout});
                });
        });
}

}  // namespace rambla::render
