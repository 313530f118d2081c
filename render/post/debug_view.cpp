#include "render/post/debug_view.h"

#include <string>

#include "render/passes/bare_mesh.h"
#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

constexpr GLint k_samples = 0;  // location in debug_view.frag.glsl

/// The texture that a view is made from; invalid where the frame has none.
TextureHandle shown(const FrameResources& resources, DebugView view) {
    switch (view) {
        case DebugView::albedo:
            return resources.albedo;
        case DebugView::normal:
            return resources.normal;
        case DebugView::roughness:
        case DebugView::metalness:
        case DebugView::occlusion:
            return resources.surface;
        case DebugView::emission:
            return resources.emission;
        case DebugView::shadow:
            return resources.shadow_result;
        case DebugView::luminance:
        case DebugView::nonfinite:
            return resources.scene_colour;
        case DebugView::objects:
            return resources.objects;
        case DebugView::off:
        case DebugView::depth:
        case DebugView::lights:
        case DebugView::tiles:
        case DebugView::overdraw:
            break;
    }
    return resources.solid_depth;
}

/// Where the picture that a view is made from shows anything: what fades is part of the lit one alone.
TextureHandle depth_of(const FrameResources& resources, DebugView view) {
    const bool lit = view == DebugView::luminance || view == DebugView::nonfinite;
    return lit ? resources.depth : resources.solid_depth;
}

}  // namespace

const gl::Program& DebugViewPass::program(DebugView view, bool missing, GBufferLayout layout) {
    const auto index = static_cast<std::size_t>(view);
    const gl::Program*& variant = variants_[4 * index + (missing ? 2 : 0) + static_cast<std::size_t>(layout)];
    if (variant == nullptr) {
        variant = &programs_.get({.name = "debug view",
                                  .vertex = "full_screen.vert.glsl",
                                  .fragment = "debug_view.frag.glsl",
                                  .compute = {},
                                  .defines = {{"VIEW", "view_" + std::string{k_debug_views[index]}},
                                              {"MISSING", missing ? "1" : "0"},
                                              {"GBUFFER_WIDE", gbuffer_define(layout)},
                                              {"IDS", view == DebugView::objects ? "1" : "0"},
                                              {"CELLS", view == DebugView::lights ? "1" : "0"},
                                              {"TILES", view == DebugView::tiles ? "1" : "0"}}});
    }
    return *variant;
}

const gl::Program& DebugViewPass::overdraw_program(bool skinned, bool morphed) {
    const gl::Program*& variant = overdraw_[(skinned ? 1u : 0u) | (morphed ? 2u : 0u)];
    if (variant == nullptr) {
        variant = &programs_.get({.name = "overdraw",
                                  .vertex = "mesh.vert.glsl",
                                  .fragment = "overdraw.frag.glsl",
                                  .compute = {},
                                  .defines = bare_mesh_defines(skinned, morphed)});
    }
    return *variant;
}

TextureHandle DebugViewPass::add_overdraw(RenderGraph& graph, FrameResources& resources) {
    TextureHandle count;
    graph.add_pass(
        "overdraw",
        [&](PassBuilder& pass) {
            const TextureHandle target =
                pass.create_texture("overdraw", {.format = GL_RGBA16F, .size = resources.size_px()});
            count = pass.write_colour(0, target, LoadOp::clear);
        },
        [this, &resources](PassContext&) {
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            resources.counts += resources.opaque.draw(
                resources.scene, [this](systems::Pipeline pipeline, std::uint32_t) -> const gl::Program& {
                    return overdraw_program(pipeline.skinned, pipeline.morphed);
                });
        });
    return count;
}

void DebugViewPass::add(RenderGraph& graph, FrameResources& resources) {
    const DebugView view = resources.settings.debug.view;
    if (view == DebugView::off) return;
    const TextureHandle source =
        view == DebugView::overdraw ? add_overdraw(graph, resources) : shown(resources, view);
    const bool tiles = view == DebugView::tiles;
    const bool missing = !source.valid() || (tiles && !resources.tiles.valid());
    const TextureHandle depth = depth_of(resources, view);
    const gl::Program& show = program(view, missing, resources.settings.gbuffer.layout);
    graph.add_pass(
        "debug view",
        [&](PassBuilder& pass) {
            if (!missing) pass.read(source);
            if (!missing) pass.read(depth);
            if (!missing && tiles) read_tiles(pass, resources.tiles);
            resources.backbuffer = pass.write_colour(0, resources.backbuffer, LoadOp::discard);
        },
        [&resources, &show, source, depth, missing, tiles](PassContext& context) {
            if (!missing) {
                context.bind_texture(UNIT_PASS, depth, resources.samplers.nearest);
                context.bind_texture(UNIT_PASS + 1, source, resources.samplers.nearest);
                if (tiles) bind_tiles(context, resources.tiles);
            }
            glDisable(GL_FRAMEBUFFER_SRGB);
            show.use();
            glUniform1i(k_samples, static_cast<GLint>(resources.frame.view.samples));
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
