#include "render/passes/light_lists.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

/// Buffers of the tiles' lists grow in powers of two, so that the graph's pool finds last frame's again.
std::size_t pooled_bytes(std::size_t bytes) {
    std::size_t size = 4096;
    while (size < bytes)
        size *= 2;
    return size;
}

bool wants_cells(const FrameResources& resources) {
    const LightingPath path = resources.settings.lighting.path;
    return path == LightingPath::clustered || path == LightingPath::forward || !resources.blended.empty() ||
           resources.settings.debug.view == DebugView::lights;
}

}  // namespace

LightListsPass::LightListsPass(gl::ProgramRegistry& programs) : programs_{programs} {}

gl::BufferRange LightListsPass::upload_cells(gl::StreamBuffer& stream, const LightBins& bins) {
    const std::span<const glm::uvec2> ranges{bins.ranges};
    const gl::StreamBuffer::Allocation memory = stream.allocate(sizeof(bins.grid) + ranges.size_bytes());
    std::memcpy(memory.data, &bins.grid, sizeof(bins.grid));
    std::memcpy(memory.data + sizeof(bins.grid), ranges.data(), ranges.size_bytes());
    return memory.range;
}

void LightListsPass::add(RenderGraph& graph, FrameResources& resources) {
    bound_lights(resources.view, resources.frame.lights, bounded_);
    resources.bounded_lights = bounded_;
    if (wants_cells(resources)) make_cells(resources);
    if (resources.settings.lighting.path == LightingPath::tiled && !bounded_.empty())
        add_tiles(graph, resources);
}

void LightListsPass::make_cells(FrameResources& resources) {
    const LightingParameters& parameters = resources.settings.lighting;
    const LightBins& bins =
        cells_.bin(resources.size_px(), bounded_, static_cast<std::uint32_t>(parameters.tile_px),
                   static_cast<std::uint32_t>(parameters.slices));
    upload_cells(resources.stream, bins).bind(GL_SHADER_STORAGE_BUFFER, BINDING_LIGHT_CELLS);
    resources.stream.upload(std::span<const std::uint32_t>{bins.entries})
        .bind(GL_SHADER_STORAGE_BUFFER, BINDING_LIGHT_ENTRIES);
}

void LightListsPass::add_tiles(RenderGraph& graph, FrameResources& resources) {
    if (sort_tiles_ == nullptr) {
        sort_tiles_ = &programs_.get({.name = "light tiles",
                                      .vertex = {},
                                      .fragment = {},
                                      .compute = "light_tiles.comp.glsl",
                                      .defines = {}});
    }
    const LightBins& bins = tiles_.bin(resources.size_px(), bounded_,
                                       static_cast<std::uint32_t>(resources.settings.lighting.tile_px), 1);
    depths_.assign(resources.frame.lights.size(), {});
    for (const BoundedLight& light : bounded_)
        depths_[light.light] = {light.bounds.nearest_m, light.bounds.farthest_m};
    const gl::BufferRange cells = upload_cells(resources.stream, bins);
    const gl::BufferRange entries = resources.stream.upload(std::span<const std::uint32_t>{bins.entries});
    const gl::BufferRange depths = resources.stream.upload(std::span<const shared::LightDepths>{depths_});
    const shared::LightGrid grid = bins.grid;
    const std::size_t tiles = bins.ranges.size();
    const std::size_t header = sizeof(shared::TileDraw) * shared::k_tile_classes + sizeof(grid);

    graph.add_pass(
        "light tiles",
        [&](PassBuilder& pass) {
            pass.read(resources.depth);
            TileLists& lists = resources.tiles;
            lists.draws = pass.write_storage(
                pass.create_buffer("tiles", pooled_bytes(header + tiles * sizeof(glm::uvec2))));
            lists.classes = pass.write_storage(pass.create_buffer(
                "tile classes", pooled_bytes(tiles * shared::k_tile_classes * sizeof(std::uint32_t))));
            lists.entries = pass.write_storage(
                pass.create_buffer("tile lights", pooled_bytes(bins.entries.size() * sizeof(std::uint32_t))));
        },
        [this, &resources, cells, entries, depths, grid](PassContext& context) {
            const GLuint draws = context.buffer(resources.tiles.draws);
            constexpr shared::TileDraw none{4, 0, 0, 0};
            constexpr auto classes_bytes = static_cast<GLsizeiptr>(sizeof(none) * shared::k_tile_classes);
            glClearNamedBufferSubData(draws, GL_RGBA32UI, 0, classes_bytes, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                                      &none);
            glClearNamedBufferSubData(draws, GL_RGBA32UI, classes_bytes, sizeof(grid.cells), GL_RGBA_INTEGER,
                                      GL_UNSIGNED_INT, &grid.cells);
            context.bind_texture(UNIT_PASS, resources.depth, resources.samplers.nearest);
            cells.bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE + 4);
            entries.bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE + 5);
            depths.bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE + 3);
            bind_tiles(context, resources.tiles);
            sort_tiles_->use();
            glDispatchCompute(grid.cells.x, grid.cells.y, 1);
        });
}

void bind_tiles(const PassContext& context, const TileLists& lists) {
    const std::array buffers{context.buffer(lists.draws), context.buffer(lists.classes),
                             context.buffer(lists.entries)};
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE, buffers.size(), buffers.data());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, context.buffer(lists.draws));
}

void read_tiles(PassBuilder& pass, const TileLists& lists) {
    pass.read(lists.draws, graph::Use::indirect);
    pass.read(lists.draws, graph::Use::storage);
    pass.read(lists.classes, graph::Use::storage);
    pass.read(lists.entries, graph::Use::storage);
}

void draw_tiles(std::uint32_t tile_class) {
    glDrawArraysIndirect(GL_TRIANGLE_STRIP, reinterpret_cast<const void*>(std::uintptr_t{tile_class} *
                                                                          sizeof(shared::TileDraw)));
}

}  // namespace rambla::render
