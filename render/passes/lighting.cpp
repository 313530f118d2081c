#include "render/passes/lighting.h"

#include <string>

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

LightingPass::LightingPass(gl::ProgramRegistry& programs) : programs_{programs} {}

LightingPass::LocalLights LightingPass::local_lights_of(const FrameResources& resources) {
    if (resources.bounded_lights.empty()) return LocalLights::none;
    switch (resources.settings.lighting.path) {
        case LightingPath::fullscreen:
            return LocalLights::all;
        case LightingPath::clustered:
            return LocalLights::cell;
        case LightingPath::tiled:
            return LocalLights::tile;
        case LightingPath::volumes:
        case LightingPath::forward:
            break;
    }
    return LocalLights::none;
}

const gl::Program& LightingPass::program(Variant v) {
    const std::size_t index = (v.shadowed ? 1u : 0u) + (v.emissive ? 2u : 0u) + (v.tiles ? 4u : 0u) +
                              8u * static_cast<std::size_t>(v.local_lights) +
                              32u * static_cast<std::size_t>(v.brdf) +
                              96u * static_cast<std::size_t>(v.layout);
    const gl::Program*& variant = variants_[index];
    if (variant == nullptr) {
        const bool lamp_lit = v.local_lights == LocalLights::tile;
        variant = &programs_.get(
            {.name = "lighting",
             .vertex = v.tiles ? "tile.vert.glsl" : "full_screen.vert.glsl",
             .fragment = "lighting.frag.glsl",
             .compute = {},
             .defines = {{"SHADOW_RESULT", v.shadowed ? "1" : "0"},
                         {"EMISSION", v.emissive ? "1" : "0"},
                         {"GBUFFER_WIDE", gbuffer_define(v.layout)},
                         {"LOCAL_LIGHTS", std::to_string(static_cast<int>(v.local_lights))},
                         {"TILE_CLASS", lamp_lit ? "k_tile_class_lamp_lit" : "k_tile_class_sky_lit"},
                         {"BRDF", std::to_string(static_cast<int>(v.brdf))}}});
    }
    return *variant;
}

void LightingPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.settings.lighting.path == LightingPath::forward) return;
    Variant variant{.shadowed = resources.shadow_result.valid(),
                    .emissive = resources.emission.valid(),
                    .local_lights = local_lights_of(resources),
                    .brdf = resources.settings.brdf.model,
                    .layout = resources.settings.gbuffer.layout};
    variant.tiles = variant.local_lights == LocalLights::tile;
    graph.add_pass(
        "lighting",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            read_gbuffer(pass, resources);
            if (variant.shadowed) pass.read(resources.shadow_result);
            if (variant.emissive) pass.read(resources.emission);
            if (variant.tiles) read_tiles(pass, resources.tiles);
            const TextureHandle colour = pass.create_texture(
                "scene colour",
                {.format = scene_colour_format(resources.settings.tone), .size = resources.size_px()});
            resources.scene_colour = pass.write_colour(0, colour, LoadOp::discard);
        },
        [this, &resources, variant](PassContext& context) {
            const gl::Sampler& nearest = resources.samplers.nearest;
            bind_gbuffer(context, resources);
            if (variant.shadowed) context.bind_texture(UNIT_PASS + 4, resources.shadow_result, nearest);
            if (variant.emissive) context.bind_texture(UNIT_PASS + 5, resources.emission, nearest);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_LESS);
            if (variant.tiles) {
                draw_by_tiles(context, resources, variant);
            } else {
                program(variant).use();
                context.draw_full_screen();
            }
        });
}

void LightingPass::draw_by_tiles(PassContext& context, const FrameResources& resources, Variant variant) {
    bind_tiles(context, resources.tiles);
    no_vertices_.bind();
    program(variant).use();
    draw_tiles(shared::k_tile_class_lamp_lit);
    variant.local_lights = LocalLights::none;
    program(variant).use();
    draw_tiles(shared::k_tile_class_sky_lit);
    resources.counts.draws += 2;
    resources.counts.calls += 2;
}

}  // namespace rambla::render
