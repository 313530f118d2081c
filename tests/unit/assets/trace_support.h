#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <list>
#include <utility>

#include "assets/trace/picture.h"
#include "assets/trace/tracer.h"

namespace rambla::assets::test {

inline constexpr double k_pi = 3.14159265358979323846;

/// A scene to be traced, and the meshes that it looks at.
struct TracedWorld {
    std::list<Mesh> meshes;
    TraceScene scene;

    std::uint32_t mesh(Mesh m) {
        meshes.push_back(std::move(m));
        scene.meshes.push_back(trace_mesh(meshes.back()));
        return static_cast<std::uint32_t>(scene.meshes.size() - 1);
    }
    std::uint32_t material(const TraceMaterial& m) {
        scene.materials.push_back(m);
        return static_cast<std::uint32_t>(scene.materials.size() - 1);
    }
    /// Instances have their own number as object, plus 100.
    TraceInstance& place(std::uint32_t mesh_index, const glm::mat4& world_from_local = glm::mat4{1.0f},
                         std::uint32_t material_index = k_none) {
        const auto object = static_cast<std::uint32_t>(100 + scene.instances.size());
        scene.instances.push_back({.mesh = mesh_index,
                                   .material = material_index,
                                   .object = object,
                                   .world_from_local = glm::mat4x3{world_from_local}});
        return scene.instances.back();
    }
    TraceInstance& place(Mesh m, const glm::mat4& world_from_local = glm::mat4{1.0f},
                         std::uint32_t material_index = k_none) {
        return place(mesh(std::move(m)), world_from_local, material_index);
    }
};

/// Half size 1, in the plane z = 0, faces +Z; uv (0, 0) at the upper left.
inline Mesh facing_square() {
    Mesh m;
    m.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    m.normals.assign(4, {0, 0, 1});
    m.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    m.indices = {0, 1, 2, 0, 2, 3};
    return m;
}

/// Half size 1, in the plane y = 0, faces +Y.
inline Mesh ground_square() {
    Mesh m;
    m.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    m.normals.assign(4, {0, 1, 0});
    m.indices = {0, 1, 2, 0, 2, 3};
    return m;
}

/// ±1 on each axis, faces outwards, without normals.
inline Mesh cube() {
    Mesh m;
    for (int i = 0; i < 8; ++i)
        m.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    m.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return m;
}

/// Unit sphere of latitudes and longitudes, with the sphere's normals. No vertex is farther from the surface
/// than rounding, and faces lie at most 1 − cos(π/rings) inside.
inline Mesh globe(std::uint32_t rings) {
    Mesh m;
    const std::uint32_t columns = 2 * rings;
    for (std::uint32_t r = 0; r <= rings; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            const double theta = k_pi * r / rings, phi = 2.0 * k_pi * c / columns;
            m.positions.emplace_back(glm::vec3{std::sin(theta) * std::cos(phi), std::cos(theta),
                                               -std::sin(theta) * std::sin(phi)});
        }
    }
    m.normals = m.positions;
    for (std::uint32_t r = 0; r < rings; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t a = r * columns + c, b = r * columns + (c + 1) % columns;
            for (const std::uint32_t i : {a, a + columns, b + columns, a, b + columns, b})
                m.indices.push_back(i);
        }
    }
    return m;
}

inline glm::mat4 moved(glm::vec3 by) {
    return glm::translate(glm::mat4{1.0f}, by);
}
inline glm::mat4 scaled(glm::vec3 by) {
    return glm::scale(glm::mat4{1.0f}, by);
}

/// A hit that looks straight down on a place of the ground: for pictures of one row whose pixels are places.
inline TraceHit ground_hit(const Tracer& tracer, glm::dvec3 above) {
    return tracer.first_hit({.origin_m = above, .direction = {0, -1, 0}}).value();
}

/// A camera at the origin that looks along −Z.
inline TraceCamera pinhole(glm::uvec2 size_px, float vertical_fov_rad = 1.0f, float near_m = 0.05f) {
    TraceCamera camera{.size_px = size_px};
    const float f = 1.0f / std::tan(0.5f * vertical_fov_rad);
    camera.clip_from_view = glm::mat4{0.0f};
    camera.clip_from_view[0][0] = f * static_cast<float>(size_px.y) / static_cast<float>(size_px.x);
    camera.clip_from_view[1][1] = f;
    camera.clip_from_view[2][3] = -1.0f;
    camera.clip_from_view[3][2] = near_m;
    return camera;
}

}  // namespace rambla::assets::test
