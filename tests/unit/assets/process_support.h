#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "assets/mesh.h"

namespace rambla::assets::test {

/// A height field over the unit square, cells × cells squares, with smooth normals and uv = (x, 1 − z).
template <class Height>
Mesh grid(int cells, Height&& height) {
    Mesh mesh;
    for (int z = 0; z <= cells; ++z)
        for (int x = 0; x <= cells; ++x) {
            const glm::vec2 at = glm::vec2{x, z} / static_cast<float>(cells);
            constexpr float k_step = 1e-3f;
            const glm::vec3 along_x{2 * k_step, height(at.x + k_step, at.y) - height(at.x - k_step, at.y), 0};
            const glm::vec3 along_z{0, height(at.x, at.y + k_step) - height(at.x, at.y - k_step), 2 * k_step};
            mesh.positions.emplace_back(at.x, height(at.x, at.y), at.y);
            mesh.normals.push_back(glm::normalize(glm::cross(along_z, along_x)));
            mesh.uv0.emplace_back(at.x, 1.0f - at.y);
        }
    const auto vertex = [&](int x, int z) {
        return static_cast<std::uint32_t>(z * (cells + 1) + x);
    };
    for (int z = 0; z < cells; ++z)
        for (int x = 0; x < cells; ++x)
            mesh.indices.insert(mesh.indices.end(),
                                {vertex(x, z), vertex(x, z + 1), vertex(x + 1, z), vertex(x + 1, z),
                                 vertex(x, z + 1), vertex(x + 1, z + 1)});
    return mesh;
}

inline Mesh flat_grid(int cells) {
    return grid(cells, [](float, float) { return 0.0f; });
}

/// A torus around +Y with outward normals and two seams of texture coordinates; closed where places are
/// welded.
inline Mesh torus(int around, int across, float radius = 1.0f, float thickness = 0.4f) {
    Mesh mesh;
    for (int i = 0; i <= around; ++i)
        for (int j = 0; j <= across; ++j) {
            // The last row repeats the first one's places exactly.
            const float a = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i % around) /
                            static_cast<float>(around);
            const float b = 2.0f * std::numbers::pi_v<float> * static_cast<float>(j % across) /
                            static_cast<float>(across);
            const glm::vec3 out{std::cos(a), 0.0f, std::sin(a)};
            const glm::vec3 normal = std::cos(b) * out + std::sin(b) * glm::vec3{0, 1, 0};
            mesh.positions.push_back(radius * out + thickness * normal);
            mesh.normals.push_back(normal);
            mesh.uv0.emplace_back(static_cast<float>(i) / static_cast<float>(around),
                                  static_cast<float>(j) / static_cast<float>(across));
        }
    const auto vertex = [&](int i, int j) {
        return static_cast<std::uint32_t>(i * (across + 1) + j);
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j)
            mesh.indices.insert(mesh.indices.end(),
                                {vertex(i, j), vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j),
                                 vertex(i, j + 1), vertex(i + 1, j + 1)});
    return mesh;
}

/// Adds a box with a normal of its own on each side: 24 vertices, facing outwards, or inwards for a room.
inline void add_box(Mesh& mesh, glm::vec3 min, glm::vec3 max, bool inwards = false) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            glm::vec3 normal{0.0f};
            normal[axis] = inwards ? -side : side;
            for (const glm::vec2 at : {glm::vec2{0, 0}, glm::vec2{1, 0}, glm::vec2{1, 1}, glm::vec2{0, 1}}) {
                glm::vec3 corner = side < 0.0f ? min : max;
                corner[u] = at.x > 0.0f ? max[u] : min[u];
                corner[v] = at.y > 0.0f ? max[v] : min[v];
                mesh.positions.push_back(corner);
                mesh.normals.push_back(normal);
                mesh.uv0.push_back(at);
            }
            const bool counter_clockwise = (side > 0.0f) != inwards;
            for (const std::uint32_t i :
                 counter_clockwise ? std::array{0u, 1u, 2u, 0u, 2u, 3u} : std::array{0u, 2u, 1u, 0u, 3u, 2u})
                mesh.indices.push_back(first + i);
        }
}

inline Mesh box(glm::vec3 min, glm::vec3 max) {
    Mesh mesh;
    add_box(mesh, min, max);
    return mesh;
}

/// A mesh of random triangles in which every column of every kind is filled.
inline Mesh random_full_mesh(std::mt19937& random, std::size_t vertices, std::size_t triangles) {
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    std::uniform_int_distribution<std::uint32_t> vertex{0, static_cast<std::uint32_t>(vertices - 1)};
    const auto vec3 = [&] {
        return glm::vec3{unit(random), unit(random), unit(random)};
    };
    Mesh mesh;
    mesh.morphs.resize(2);
    for (std::size_t i = 0; i < vertices; ++i) {
        mesh.positions.push_back(vec3());
        mesh.normals.push_back(glm::normalize(vec3()));
        mesh.tangents.emplace_back(glm::normalize(vec3()), 1.0f);
        mesh.uv0.emplace_back(unit(random), unit(random));
        mesh.uv1.emplace_back(unit(random), unit(random));
        mesh.colours.emplace_back(vec3(), 1.0f);
        mesh.joints.emplace_back(vertex(random), vertex(random), vertex(random), vertex(random));
        mesh.weights.emplace_back(0.5f, 0.5f * std::abs(unit(random)), 0.0f, 0.0f);
        for (MorphTarget& morph : mesh.morphs) {
            morph.positions.push_back(vec3());
            morph.normals.push_back(vec3());
            morph.tangents.push_back(vec3());
        }
    }
    for (std::size_t i = 0; i < 3 * triangles; ++i)
        mesh.indices.push_back(vertex(random));
    return mesh;
}

/// Nearest distance from a point to triangles, one after the other, by a formula of its own: the distance to
/// the plane where the foot lies within all three edges' half planes, else to an edge.
inline double distance_to(glm::dvec3 point, const std::vector<glm::vec3>& positions,
                          const std::uint32_t* indices, std::size_t count) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 2 < count; i += 3) {
        const std::array<glm::dvec3, 3> t{positions[indices[i]], positions[indices[i + 1]],
                                          positions[indices[i + 2]]};
        const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
        bool within = glm::length(normal) > 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 a = t[c];
            const glm::dvec3 b = t[(c + 1) % 3];
            if (glm::dot(glm::cross(b - a, point - a), normal) < 0.0) within = false;
            const double length_squared = glm::dot(b - a, b - a);
            const double share = length_squared > 0.0
                                     ? glm::clamp(glm::dot(point - a, b - a) / length_squared, 0.0, 1.0)
                                     : 0.0;
            best = std::min(best, glm::distance(point, a + share * (b - a)));
        }
        if (within) best = std::min(best, std::abs(glm::dot(point - t[0], glm::normalize(normal))));
    }
    return best;
}

/// The largest of distances from points spread over triangles, `rows` along each edge, to other triangles.
inline double sampled_deviation(const std::vector<glm::vec3>& positions, const std::uint32_t* from,
                                std::size_t from_count, const std::uint32_t* to, std::size_t to_count,
                                int rows) {
    double largest = 0.0;
    for (std::size_t i = 0; i + 2 < from_count; i += 3)
        for (int a = 0; a <= rows; ++a)
            for (int b = 0; a + b <= rows; ++b) {
                const glm::dvec3 w = glm::dvec3{a, b, rows - a - b} / static_cast<double>(rows);
                const glm::dvec3 point = w.x * glm::dvec3{positions[from[i]]} +
                                         w.y * glm::dvec3{positions[from[i + 1]]} +
                                         w.z * glm::dvec3{positions[from[i + 2]]};
                largest = std::max(largest, distance_to(point, positions, to, to_count));
            }
    return largest;
}

}  // namespace rambla::assets::test
