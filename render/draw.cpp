#include "render/draw.h"

#include "assets/material.h"
#include "assets/mesh.h"

namespace rambla::render {

namespace {

bool is_masked(systems::Pipeline pipeline) {
    return pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask);
}

/// The pipeline as far as a depth-only pass can tell one from another.
std::uint32_t depth_pipeline(std::uint32_t bits) {
    systems::Pipeline pipeline = systems::unpack_pipeline(bits);
    pipeline.unlit = false;
    if (!is_masked(pipeline)) pipeline.alpha = static_cast<std::uint8_t>(assets::AlphaMode::opaque);
    return systems::pack(pipeline);
}

GLenum gl_topology(systems::Pipeline pipeline) {
    switch (static_cast<assets::Topology>(pipeline.topology)) {
        case assets::Topology::triangles:
            return GL_TRIANGLES;
        case assets::Topology::lines:
            return GL_LINES;
        case assets::Topology::points:
            return GL_POINTS;
    }
    return GL_TRIANGLES;
}

}  // namespace

void DrawList::clear(DrawKind kind) {
    kind_ = kind;
    commands_.clear();
    runs_.clear();
    range_ = {};
}

bool DrawList::is_drawn_twice(std::uint32_t pipeline) const {
    const systems::Pipeline unpacked = systems::unpack_pipeline(pipeline);
    return kind_ == DrawKind::blended && (unpacked.double_sided || unpacked.fading);
}

bool DrawList::draws_shadow_meshes(systems::Pipeline pipeline) const {
    return kind_ == DrawKind::depth_only && !is_masked(pipeline) && !pipeline.skinned && !pipeline.morphed &&
           pipeline.topology == static_cast<std::uint8_t>(assets::Topology::triangles);
}

bool DrawList::continues(const Run& run, std::uint32_t pipeline, std::uint32_t material) const {
    if (run.pipeline != pipeline || is_drawn_twice(pipeline)) return false;
    if (run.material == material) return true;
    return kind_ == DrawKind::depth_only && !is_masked(systems::unpack_pipeline(pipeline));
}

void DrawList::add(const SceneStore& scene, std::uint32_t pipeline, std::uint32_t material,
                   std::uint32_t mesh, std::uint32_t first_instance, std::uint32_t instance_count) {
    const MeshRange& range =
        draws_shadow_meshes(systems::unpack_pipeline(pipeline)) ? scene.shadow_mesh(mesh) : scene.mesh(mesh);
    if (range.index_count == 0 || instance_count == 0) return;
    if (kind_ == DrawKind::depth_only) pipeline = depth_pipeline(pipeline);
    if (runs_.empty() || !continues(runs_.back(), pipeline, material)) {
        runs_.push_back({.pipeline = pipeline,
                         .material = material,
                         .first_command = static_cast<std::uint32_t>(commands_.size()),
                         .command_count = 0,
                         .triangles = 0});
    }
    Run& run = runs_.back();
    if (range.topology == assets::Topology::triangles) {
        run.triangles += std::uint64_t{range.index_count / 3} * instance_count;
    }
    if (run.command_count > 0) {
        Command& last = commands_.back();
        if (last.first_index == range.first_index && last.base_vertex == range.base_vertex &&
            last.base_instance + last.instance_count == first_instance) {
            last.instance_count += instance_count;
            return;
        }
    }
    ++run.command_count;
    commands_.push_back({.index_count = range.index_count,
                         .instance_count = instance_count,
                         .first_index = range.first_index,
                         .base_vertex = range.base_vertex,
                         .base_instance = first_instance});
}

void DrawList::add(const SceneStore& scene, std::span<const systems::DrawBatch> batches) {
    for (const systems::DrawBatch& batch : batches) {
        const std::uint32_t at_once = is_drawn_twice(batch.pipeline) ? 1 : batch.instance_count;
        for (std::uint32_t i = 0; i < batch.instance_count; i += at_once) {
            add(scene, batch.pipeline, batch.material, batch.mesh, batch.first_instance + i, at_once);
        }
    }
}

void DrawList::add(const SceneStore& scene, const systems::CasterColumns& casters,
                   std::span<const std::uint32_t> rows) {
    for (const std::uint32_t row : rows) {
        add(scene, casters.pipeline[row], casters.material[row], casters.mesh[row], casters.instance[row], 1);
    }
}

void DrawList::upload(gl::StreamBuffer& stream) {
    range_ = stream.upload(std::span<const Command>{commands_});
}

void DrawList::begin() const {
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, range_.buffer);
}

void DrawList::draw_run(const SceneStore& scene, const Run& run, DrawCounts& counts) const {
    const systems::Pipeline pipeline = systems::unpack_pipeline(run.pipeline);
    const bool shadow_meshes = draws_shadow_meshes(pipeline);
    (shadow_meshes ? scene.shadow_vertices() : scene.vertices(pipeline.skinned)).bind();
    glFrontFace(pipeline.mirrored ? GL_CW : GL_CCW);
    if (kind_ != DrawKind::depth_only) {
        scene.bind_textures(run.material);
    } else if (is_masked(pipeline)) {
        scene.bind_base_colour(run.material);
    }
    if (pipeline.double_sided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
    if (!is_drawn_twice(run.pipeline)) {
        draw_commands(run, counts);
    } else if (pipeline.fading) {
        draw_fading(run, counts);
    } else {
        draw_sides(run, counts);
    }
}

void DrawList::draw_sides(const Run& run, DrawCounts& counts) const {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    draw_commands(run, counts);
    glCullFace(GL_BACK);
    draw_commands(run, counts);
}

/// Where it lies over itself only what is nearest may be blended, or it would be less transparent there.
void DrawList::draw_fading(const Run& run, DrawCounts& counts) const {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_TRUE);
    draw_commands(run, counts);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    draw_commands(run, counts);
    glDepthFunc(GL_GREATER);
}

void DrawList::draw_commands(const Run& run, DrawCounts& counts) const {
    const std::uintptr_t offset =
        static_cast<std::uintptr_t>(range_.offset) + run.first_command * sizeof(Command);
    glMultiDrawElementsIndirect(gl_topology(systems::unpack_pipeline(run.pipeline)), GL_UNSIGNED_INT,
                                reinterpret_cast<const void*>(offset),
                                static_cast<GLsizei>(run.command_count), sizeof(Command));
    counts.draws += run.command_count;
    counts.calls += 1;
    counts.triangles += run.triangles;
}

void DrawList::end() {
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
}

}  // namespace rambla::render
