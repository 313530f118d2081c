#include "render/post/edge_smoothing.h"

#include <string>
#include <utility>
#include <vector>

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/edge_tiles.h"

namespace rambla::render {
namespace {

constexpr GLuint k_display_unit = UNIT_PASS;
constexpr GLuint k_depth_unit = UNIT_PASS + 1;
constexpr GLuint k_normal_unit = UNIT_PASS + 2;
constexpr GLuint k_edges_unit = UNIT_PASS + 3;

glm::uvec2 divided(glm::uvec2 size, std::uint32_t by) {
    return (size + by - 1u) / by;
}

/// Names are literals, which the graph keeps.
const char* pass_name(AntiAliasing method) {
    return k_anti_aliasing_methods[static_cast<std::size_t>(method)].data();
}

/// The file of a method's edges, and of what it makes of them.
const char* shader_of(AntiAliasing method) {
    switch (method) {
        case AntiAliasing::sobel:
        case AntiAliasing::edges:
            return "edge_blur.frag.glsl";
        case AntiAliasing::morphological:
            return "morphological.frag.glsl";
        default:
            return "fxaa.frag.glsl";
    }
}

bool reads_depth(const AntiAliasingParameters& parameters) {
    return parameters.method == AntiAliasing::edges ||
           (parameters.method == AntiAliasing::sobel && parameters.sobel_of == SobelOf::depth);
}

/// The textures that a method looks for edges in.
void read_sources(PassBuilder& pass, const FrameResources& resources, bool depth, bool normals) {
    pass.read(resources.display);
    if (depth) pass.read(resources.depth);
    if (normals) pass.read(resources.normal);
}

void bind_sources(const PassContext& context, const FrameResources& resources, bool depth, bool normals) {
    // What is blurred is mixed in hardware; all else falls on texels, or on corners of them for gathers.
    context.bind_texture(k_display_unit, resources.display, resources.samplers.linear);
    if (depth) context.bind_texture(k_depth_unit, resources.depth, resources.samplers.nearest);
    if (normals) context.bind_texture(k_normal_unit, resources.normal, resources.samplers.nearest);
}

}  // namespace

void EdgeSmoothingPass::choose(const Choice& choice) {
    if (choice == choice_) return;
    std::vector<std::pair<std::string, std::string>> defines;
    const auto define = [&](const char* name, bool value) {
        defines.emplace_back(name, value ? "1" : "0");
    };
    define("SOBEL", choice.method == AntiAliasing::sobel);
    define("SOBEL_OF_DEPTH", choice.sobel_of == SobelOf::depth);
    define("EDGES", choice.method == AntiAliasing::edges);
    define("FXAA", choice.method == AntiAliasing::fxaa);
    define("MORPHOLOGICAL", choice.method == AntiAliasing::morphological);
    define("NORMALS", choice.has_normals);
    defines.emplace_back("GBUFFER_WIDE", gbuffer_define(choice.layout));
    defines.emplace_back("QUALITY", std::to_string(static_cast<int>(choice.quality)));
    find_tiles_ = nullptr;
    // The lines that morphological looks for are made where tiles are looked for.
    if (!choice.everywhere || choice.method == AntiAliasing::morphological) {
        find_tiles_ = &programs_.get({.name = "edge tiles",
                                      .vertex = {},
                                      .fragment = {},
                                      .compute = "edge_tiles.comp.glsl",
                                      .defines = defines});
    }
    smooth_ = &programs_.get({.name = pass_name(choice.method),
                              .vertex = choice.everywhere ? "full_screen.vert.glsl" : "edge_tile.vert.glsl",
                              .fragment = shader_of(choice.method),
                              .compute = {},
                              .defines = std::move(defines)});
    choice_ = choice;
}

void EdgeSmoothingPass::add(RenderGraph& graph, FrameResources& resources) {
    const AntiAliasingParameters& parameters = resources.settings.anti_aliasing;
    if (!smooths_edges(parameters.method)) return;
    // What a method does not read is the same in all its choices, so that it has one set of programs.
    Choice choice{.method = parameters.method, .everywhere = parameters.everywhere};
    if (parameters.method == AntiAliasing::sobel) choice.sobel_of = parameters.sobel_of;
    if (parameters.method == AntiAliasing::fxaa || parameters.method == AntiAliasing::morphological)
        choice.quality = parameters.quality;
    if (parameters.method == AntiAliasing::edges) {
        choice.has_normals = resources.normal.valid();
        choice.layout = resources.settings.gbuffer.layout;
    }
    choose(choice);
    tiles_ = {};
    if (find_tiles_ != nullptr) add_tiles(graph, resources);
    add_smoothing(graph, resources);
}

void EdgeSmoothingPass::add_tiles(RenderGraph& graph, const FrameResources& resources) {
    const glm::uvec2 grid = divided(resources.size_px(), shared::k_edge_tile_px);
    const bool depth = reads_depth(resources.settings.anti_aliasing);
    const bool normals = choice_.has_normals;
    graph.add_pass(
        "edge tiles",
        [&](PassBuilder& pass) {
            read_sources(pass, resources, depth, normals);
            const std::size_t bytes =
                sizeof(shared::EdgeTileDraw) + sizeof(std::uint32_t) * std::size_t{grid.x} * grid.y;
            tiles_.list = pass.write_storage(pass.create_buffer("edge tiles", bytes));
            if (choice_.method != AntiAliasing::morphological) return;
            tiles_.edges =
                pass.write_image(pass.create_texture("edges", {.format = GL_RG32UI, .size = grid}));
        },
        [this, &resources, grid, depth, normals](PassContext& context) {
            const GLuint list = context.buffer(tiles_.list);
            constexpr shared::EdgeTileDraw none{0, 1, 0, 0};
            glClearNamedBufferSubData(list, GL_RGBA32UI, 0, sizeof(none), GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                                      &none);
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE, list);
            bind_sources(context, resources, depth, normals);
            if (tiles_.edges.valid())
                glBindImageTexture(0, context.texture(tiles_.edges), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                                   GL_RG32UI);
            find_tiles_->use();
            const glm::uvec2 groups = divided(grid, EDGE_TILES_OF_GROUP);
            glDispatchCompute(groups.x, groups.y, 1);
        });
}

void EdgeSmoothingPass::add_smoothing(RenderGraph& graph, FrameResources& resources) {
    const glm::uvec2 grid = divided(resources.size_px(), shared::k_edge_tile_px);
    const bool depth = reads_depth(resources.settings.anti_aliasing);
    const bool normals = choice_.has_normals;
    graph.add_pass(
        pass_name(choice_.method),
        [&](PassBuilder& pass) {
            read_sources(pass, resources, depth, normals);
            pass.read(resources.display, graph::Use::transfer);
            if (tiles_.edges.valid()) pass.read(tiles_.edges);
            if (!choice_.everywhere) {
                pass.read(tiles_.list, graph::Use::indirect);
                pass.read(tiles_.list, graph::Use::storage);
            }
            resources.backbuffer = pass.write_colour(0, resources.backbuffer, LoadOp::discard);
        },
        [this, &resources, grid, depth, normals](PassContext& context) {
            context.copy_into_target(resources.display);
            bind_sources(context, resources, depth, normals);
            if (tiles_.edges.valid())
                context.bind_texture(k_edges_unit, tiles_.edges, resources.samplers.nearest);
            glDisable(GL_FRAMEBUFFER_SRGB);  // colours are encoded already
            smooth_->use();
            if (choice_.everywhere) {
                context.draw_full_screen();
                return;
            }
            const GLuint list = context.buffer(tiles_.list);
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE, list);
            glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list);
            // Whole tiles, so that no point's centre lies outside and is clipped; pixels that are not there
            // are not drawn.
            const glm::uvec2 covered = grid * shared::k_edge_tile_px;
            glViewport(0, 0, static_cast<GLsizei>(covered.x), static_cast<GLsizei>(covered.y));
            glEnable(GL_PROGRAM_POINT_SIZE);
            context.bind_no_vertices();
            glDrawArraysIndirect(GL_POINTS, nullptr);
            glDisable(GL_PROGRAM_POINT_SIZE);
        });
}

}  // namespace rambla::render
