#include "game/study/deformed_mesh.h"

#include <array>
#include <cstddef>

#include "assets/assert.h"
#include "render/scene_meshes.h"

namespace rambla::game::study {
namespace {

/// Rows of an affine map.
struct Rows {
    glm::dvec4 row0{0.0};
    glm::dvec4 row1{0.0};
    glm::dvec4 row2{0.0};

    [[nodiscard]] glm::dvec3 place(glm::dvec3 position) const {
        const glm::dvec4 p{position, 1.0};
        return {glm::dot(row0, p), glm::dot(row1, p), glm::dot(row2, p)};
    }
    /// By the inverse transpose, but for a factor: see mesh.vert.glsl.
    [[nodiscard]] glm::dvec3 turn(glm::dvec3 normal) const {
        const glm::dvec3 r0{row0}, r1{row1}, r2{row2};
        const double handedness = glm::dot(r0, glm::cross(r1, r2)) < 0.0 ? -1.0 : 1.0;
        return handedness * glm::dvec3{glm::dot(glm::cross(r1, r2), normal),
                                       glm::dot(glm::cross(r2, r0), normal),
                                       glm::dot(glm::cross(r0, r1), normal)};
    }
};

/// The mean of a vertex' joints.
Rows skin(const assets::Mesh& mesh, std::size_t vertex, std::span<const systems::JointMatrix> joints) {
    const render::PackedSkin packed = render::pack_skin(mesh, vertex);
    Rows rows;
    for (unsigned i = 0; i < 4; ++i) {
        const double weight = static_cast<double>((packed.weights >> (16u * i)) & 0xffffu) / 65535.0;
        const systems::JointMatrix& joint = joints[(packed.joints >> (16u * i)) & 0xffffu];
        rows.row0 += weight * glm::dvec4{joint.row0};
        rows.row1 += weight * glm::dvec4{joint.row1};
        rows.row2 += weight * glm::dvec4{joint.row2};
    }
    return rows;
}

/// A vertex' column entry with what the terms of an instance add to it.
glm::dvec3 morphed(glm::vec3 value, std::size_t vertex, std::span<const systems::MorphTerm> terms,
                   std::vector<glm::vec3> assets::MorphTarget::*column,
                   std::span<const assets::MorphTarget* const> targets) {
    glm::dvec3 sum{value};
    for (const systems::MorphTerm& term : terms) {
        if (term.weight == 0.0f) break;
        RAMBLA_ASSERT(term.target < targets.size(), "Frames use the uploaded scene's targets");
        const std::vector<glm::vec3>& deltas = targets[term.target]->*column;
        if (!deltas.empty()) sum += static_cast<double>(term.weight) * glm::dvec3{deltas[vertex]};
    }
    return sum;
}

}  // namespace

std::vector<const assets::MorphTarget*> morph_targets(const assets::ProcessedScene& scene) {
    std::vector<const assets::MorphTarget*> targets;
    for (const assets::ProcessedMesh& processed : scene.meshes) {
        for (const assets::MorphTarget& target : processed.mesh.morphs)
            targets.push_back(&target);
    }
    return targets;
}

DeformedMesh deformed(const assets::Mesh& mesh, const systems::Instance& instance, systems::Pipeline pipeline,
                      const systems::Frame& frame, std::span<const assets::MorphTarget* const> targets) {
    const std::span<const systems::MorphTerm> terms = pipeline.morphed
                                                          ? std::span{frame.morphs}.subspan(instance.morphs)
                                                          : std::span<const systems::MorphTerm>{};
    DeformedMesh result;
    result.positions.reserve(mesh.positions.size());
    result.normals.reserve(mesh.normals.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::dvec3 position = morphed(mesh.positions[v], v, terms, &assets::MorphTarget::positions, targets);
        glm::dvec3 normal{0.0};
        if (!mesh.normals.empty())
            normal = morphed(mesh.normals[v], v, terms, &assets::MorphTarget::normals, targets);
        if (pipeline.skinned) {
            const Rows rows = skin(mesh, v, std::span{frame.joints}.subspan(instance.joints));
            position = rows.place(position);
            normal = rows.turn(normal);
            // Like those that no map turns: all corners of a triangle count alike.
            if (const double length = glm::length(normal); length > 0.0) normal /= length;
        }
        result.positions.emplace_back(position);
        if (!mesh.normals.empty()) result.normals.emplace_back(normal);
    }
    return result;
}

}  // namespace rambla::game::study
