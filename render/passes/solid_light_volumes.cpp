#include "render/passes/solid_light_volumes.h"

#include <span>
#include <string>

#include "render/passes/gbuffer.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

void keep_what_lies_behind_front_faces() {
    glCullFace(GL_BACK);
    glDepthFunc(GL_GREATER);
}

void keep_what_lies_before_back_faces() {
    glCullFace(GL_FRONT);
    glDepthFunc(GL_LESS);
}

}  // namespace

SolidLightVolumesPass::Meshes SolidLightVolumesPass::make_meshes() {
    Meshes meshes;
    HullMesh all;
    for (std::size_t shape = 0; shape < k_hull_shapes; ++shape) {
        const HullMesh mesh = hull_mesh(static_cast<HullShape>(shape));
        meshes.shapes[shape] = {.count = static_cast<std::uint32_t>(mesh.indices.size()),
                                .first = static_cast<std::uint32_t>(all.indices.size()),
                                .base_vertex = static_cast<std::int32_t>(all.vertices.size())};
        all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        all.indices.insert(all.indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    meshes.vertices = {"light hulls", std::span{all.vertices}.size_bytes(), all.vertices.data()};
    meshes.indices = {"light hull indices", std::span{all.indices}.size_bytes(), all.indices.data()};
    meshes.array = gl::VertexArray{"light hulls"};
    meshes.array.attribute({.location = ATTRIBUTE_POSITION, .components = 4});
    meshes.array.vertex_buffer(0, meshes.vertices.name(), sizeof(glm::vec4));
    meshes.array.index_buffer(meshes.indices.name());
    return meshes;
}

const gl::Program& SolidLightVolumesPass::program(Brdf brdf, GBufferLayout layout) {
    const gl::Program*& variant = variants_[static_cast<std::size_t>(brdf) * k_gbuffer_layouts.size() +
                                            static_cast<std::size_t>(layout)];
    if (variant == nullptr) {
        variant = &programs_.get({.name = "solid light volume",
                                  .vertex = "light_hull.vert.glsl",
                                  .fragment = "light_volume.frag.glsl",
                                  .compute = {},
                                  .defines = {{"MEETS_SKY", "1"},
                                              {"GBUFFER_WIDE", gbuffer_define(layout)},
                                              {"BRDF", std::to_string(static_cast<int>(brdf))}}});
    }
    return *variant;
}

const gl::Program& SolidLightVolumesPass::tester() {
    if (tester_ == nullptr) {
        tester_ = &programs_.get({.name = "solid light test",
                                  .vertex = "light_hull.vert.glsl",
                                  .fragment = {},
                                  .compute = {},
                                  .defines = {}});
    }
    return *tester_;
}

void SolidLightVolumesPass::make_groups(const FrameResources& resources) {
    for (Group& group : groups_)
        group.hulls.clear();
    for (const BoundedLight& light : resources.bounded_lights) {
        const Hull hull = light_hull(resources.frame.lights[light.light], light.light);
        const bool cut = reaches_near_plane(resources.view, hull);
        groups_[2 * static_cast<std::size_t>(hull.shape) + (cut ? 1 : 0)].hulls.push_back(hull.place);
    }
    for (Group& group : groups_)
        group.range = resources.stream.upload(std::span<const shared::LightHull>{group.hulls});
}

void SolidLightVolumesPass::add(RenderGraph& graph, FrameResources& resources) {
    const LightingParameters& parameters = resources.settings.lighting;
    if (parameters.path != LightingPath::volumes || parameters.volume != LightVolume::solid) {
        meshes_.reset();
        return;
    }
    if (resources.bounded_lights.empty()) return;
    make_groups(resources);
    if (!meshes_) meshes_ = make_meshes();
    const gl::Program& light = program(resources.settings.brdf.model, resources.settings.gbuffer.layout);
    if (parameters.queries) static_cast<void>(tester());
    graph.add_pass(
        "light volumes",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.depth);
            read_gbuffer(pass, resources);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, &light, queries = parameters.queries](PassContext& context) {
            bind_gbuffer(context, resources);
            meshes_->array.bind();
            glEnable(GL_DEPTH_TEST);
            glEnable(GL_CULL_FACE);
            // What lies before a back face beyond the far plane is in reach; a perspective has no such plane.
            if (resources.view.orthographic) glEnable(GL_DEPTH_CLAMP);
            if (queries) test_each();
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            light.use();
            draw_all(queries, resources.counts);
        });
}

void SolidLightVolumesPass::draw(const Group& group, std::uint32_t first, std::uint32_t count) const {
    const Indices& mesh = meshes_->shapes[static_cast<std::size_t>(group.shape)];
    const std::uintptr_t offset = std::uintptr_t{mesh.first} * sizeof(std::uint32_t);
    glDrawElementsInstancedBaseVertexBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(mesh.count),
                                                  GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset),
                                                  static_cast<GLsizei>(count), mesh.base_vertex, first);
}

void SolidLightVolumesPass::test_each() {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    keep_what_lies_before_back_faces();
    tester_->use();
    std::size_t query = 0;
    for (const Group& group : groups_) {
        if (group.cut || group.hulls.empty()) continue;
        group.range.bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE);
        for (std::uint32_t hull = 0; hull < group.hulls.size(); ++hull, ++query) {
            if (query == queries_.size()) queries_.emplace_back("light", GL_ANY_SAMPLES_PASSED);
            glBeginQuery(GL_ANY_SAMPLES_PASSED, queries_[query].name());
            draw(group, hull, 1);
            glEndQuery(GL_ANY_SAMPLES_PASSED);
        }
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void SolidLightVolumesPass::draw_each(const Group& group, std::size_t first_query) const {
    for (std::uint32_t hull = 0; hull < group.hulls.size(); ++hull) {
        glBeginConditionalRender(queries_[first_query + hull].name(), GL_QUERY_WAIT);
        draw(group, hull, 1);
        glEndConditionalRender();
    }
}

void SolidLightVolumesPass::draw_all(bool queried, DrawCounts& counts) const {
    std::size_t first_query = 0;
    for (const Group& group : groups_) {
        if (group.hulls.empty()) continue;
        const auto count = static_cast<std::uint32_t>(group.hulls.size());
        group.range.bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE);
        group.cut ? keep_what_lies_before_back_faces() : keep_what_lies_behind_front_faces();
        const bool one_by_one = queried && !group.cut;
        if (one_by_one) {
            draw_each(group, first_query);
            first_query += count;
        } else {
            draw(group, 0, count);
        }
        counts.draws += one_by_one ? 2 * count : 1;
        counts.calls += one_by_one ? 2 * count : 1;
        counts.triangles +=
            std::uint64_t{meshes_->shapes[static_cast<std::size_t>(group.shape)].count / 3} * count;
    }
}

}  // namespace rambla::render
