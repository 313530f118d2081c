#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "assets/material.h"
#include "assets/mesh.h"
#include "assets/trace/alpha_texture.h"

namespace rambla::assets {

/// Triangles to be traced. The columns belong to someone else and must outlive the Tracer; they are either
/// empty or as long as `positions`.
struct TraceMesh {
    std::span<const glm::vec3>
        positions;                       ///< metres; triangles with a corner that is not finite do not exist
    std::span<const glm::vec3> normals;  ///< empty: those of the triangles
    std::span<const glm::vec2> uv0;      ///< empty: (0, 0)
    std::span<const glm::vec2> uv1;      ///< empty: (0, 0)
    std::span<const glm::vec4> colours;  ///< only alpha counts; empty: 1
    std::span<const std::uint32_t> indices;  ///< triangle list, counter-clockwise from the front
};

/// The columns of a mesh. Lines and points are not traced: theirs is a mesh without triangles.
[[nodiscard]] inline TraceMesh trace_mesh(const Mesh& mesh) {
    if (mesh.topology != Topology::triangles) return {};
    return {.positions = mesh.positions,
            .normals = mesh.normals,
            .uv0 = mesh.uv0,
            .uv1 = mesh.uv1,
            .colours = mesh.colours,
            .indices = mesh.indices};
}

/// What rays need to know of a material. Masked: where factor · vertex alpha · texture alpha is below the
/// cutoff, there is nothing.
struct TraceMaterial {
    bool double_sided = false;
    bool masked = false;
    float cutoff = 0.5f;
    float alpha = 1.0f;              ///< factor
    std::uint32_t texture = k_none;  ///< of TraceScene::textures; k_none: alpha 1
    TextureSlot slot{};              ///< uv set and transform; the index in it does not count
};

/// What TraceInstance::rays and TraceRay::rays have in common decides whether a ray can meet an instance.
inline constexpr std::uint32_t k_rays_of_sight = 1;
inline constexpr std::uint32_t k_rays_of_light = 2;
inline constexpr std::uint32_t k_rays_of_all = 3;

/// A mesh that stands somewhere.
struct TraceInstance {
    std::uint32_t mesh = 0;           ///< of TraceScene::meshes
    std::uint32_t material = k_none;  ///< of TraceScene::materials; k_none: opaque, single-sided
    std::uint32_t object = 0;         ///< whatever the caller tells things apart by
    std::uint32_t rays = k_rays_of_all;
    /// Affine; may mirror, shear or flatten. Where it is not finite, the instance does not exist.
    glm::mat4x3 world_from_local{1.0f};
    /// Triangles are clockwise from the front in the mesh's own space: of meshes that a mirroring map has
    /// already deformed.
    bool clockwise = false;
};

/// Plain data that a Tracer is made of.
struct TraceScene {
    std::vector<TraceMesh> meshes;
    std::vector<AlphaTexture> textures;
    std::vector<TraceMaterial> materials;
    std::vector<TraceInstance> instances;
};

}  // namespace rambla::assets
