#include "assets/process/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "assets/assert.h"
#include "assets/mesh_columns.h"

namespace rambla::assets {

namespace {

constexpr glm::vec3 k_up{0.0f, 1.0f, 0.0f};

/// Unit vector along v, or `fallback` where v has no direction.
glm::vec3 direction_or(glm::vec3 v, glm::vec3 fallback) {
    const float length = glm::length(v);
    return length > 1e-20f && std::isfinite(length) ? v / length : fallback;
}

template <class T>
std::vector<T> gathered(const std::vector<T>& column, const std::vector<std::uint32_t>& indices) {
    std::vector<T> out;
    if (column.empty()) return out;
    out.reserve(indices.size());
    for (const std::uint32_t index : indices)
        out.push_back(column[index]);
    return out;
}

/// Gives every index a vertex of its own.
void split_all(Mesh& mesh) {
    for_each_column(mesh, [&](auto& column) { column = gathered(column, mesh.indices); });
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
}

/// Appends a copy of a vertex and returns its index.
std::uint32_t duplicate(Mesh& mesh, std::uint32_t vertex) {
    for_each_column(mesh, [&](auto& column) {
        if (column.empty()) return;
        const auto value = column[vertex];
        column.push_back(value);
    });
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Normals of triangles whose vertices are not shared, one for each vertex.
std::vector<glm::vec3> flat_normals(const std::vector<glm::vec3>& positions) {
    std::vector<glm::vec3> normals(positions.size());
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
        const glm::vec3* const p = &positions[i];
        std::fill_n(&normals[i], 3, direction_or(glm::cross(p[1] - p[0], p[2] - p[0]), k_up));
    }
    return normals;
}

/// How a triangle's texture coordinates run over its surface.
struct Chart {
    glm::vec3 tangent{0.0f};  ///< unit vector along increasing u; zero where the coordinates are degenerate
    bool mirrored = false;  ///< u, v and the front face form a left-handed system when v points up the image
};

/// Solves p = o + u · T + v · B over the triangle: T = (e₁ v₂ − e₂ v₁) / det with det = u₁ v₂ − u₂ v₁. Only
/// the sign of det matters for T's direction. Image rows count downwards, so positive det (u right, v down,
/// seen from the front turning clockwise) means a mirrored image.
Chart chart_of(const std::array<glm::vec3, 3>& p, const std::array<glm::vec2, 3>& uv) {
    const glm::vec2 d1 = uv[1] - uv[0];
    const glm::vec2 d2 = uv[2] - uv[0];
    // In double: charts of one texel in a large atlas would cancel in float.
    const double det = double{d1.x} * double{d2.y} - double{d2.x} * double{d1.y};
    if (det == 0.0 || !std::isfinite(det)) return {};
    const float sign = det > 0.0 ? 1.0f : -1.0f;
    const glm::vec3 along_u = sign * ((p[1] - p[0]) * d2.y - (p[2] - p[0]) * d1.y);
    return {direction_or(along_u, glm::vec3{0.0f}), det > 0.0};
}

float angle_between(glm::vec3 a, glm::vec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

template <class Column>
std::array<typename Column::value_type, 3> corners(const Column& column, const std::uint32_t* triangle) {
    return {column[triangle[0]], column[triangle[1]], column[triangle[2]]};
}

enum class Handedness : std::uint8_t { unknown, plain, mirrored };

/// Gives every vertex faces of one handedness only. Faces without a chart join whatever their vertices have.
std::vector<Handedness> split_mirrored_vertices(Mesh& mesh, const std::vector<Chart>& charts) {
    std::vector<Handedness> handedness(mesh.positions.size(), Handedness::unknown);
    std::vector<std::uint32_t> twin(mesh.positions.size(), 0xffffffffu);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const Chart& chart = charts[i / 3];
        if (chart.tangent == glm::vec3{0.0f}) continue;
        const Handedness wanted = chart.mirrored ? Handedness::mirrored : Handedness::plain;
        const std::uint32_t vertex = mesh.indices[i];
        if (handedness[vertex] == Handedness::unknown) handedness[vertex] = wanted;
        if (handedness[vertex] == wanted) continue;
        if (twin[vertex] == 0xffffffffu) {
            twin[vertex] = duplicate(mesh, vertex);
            handedness.push_back(wanted);
            twin.push_back(0xffffffffu);
        }
        mesh.indices[i] = twin[vertex];
    }
    return handedness;
}

}  // namespace

glm::vec3 any_perpendicular(glm::vec3 normal) {
    const float sign = std::copysign(1.0f, normal.z);
    const float a = -1.0f / (sign + normal.z);
    const glm::vec3 tangent{1.0f + sign * normal.x * normal.x * a, sign * normal.x * normal.y * a,
                            -sign * normal.x};
    return glm::normalize(tangent);
}

void compute_normals(Mesh& mesh) {
    RAMBLA_ASSERT(mesh.topology == Topology::triangles, "only triangles have normals");
    std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3{0.0f});
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto p = corners(mesh.positions, &mesh.indices[i]);
        // Twice the area long: the weight comes for free.
        const glm::vec3 weighted = glm::cross(p[1] - p[0], p[2] - p[0]);
        for (std::size_t c = 0; c < 3; ++c)
            sums[mesh.indices[i + c]] += weighted;
    }
    mesh.normals.resize(sums.size());
    for (std::size_t v = 0; v < sums.size(); ++v)
        mesh.normals[v] = direction_or(sums[v], k_up);
}

void compute_flat_normals(Mesh& mesh) {
    RAMBLA_ASSERT(mesh.topology == Topology::triangles, "only triangles have normals");
    mesh.normals.clear();
    mesh.tangents.clear();
    split_all(mesh);
    mesh.normals = flat_normals(mesh.positions);
    for (MorphTarget& target : mesh.morphs) {
        target.tangents.clear();
        target.normals.clear();
        if (target.positions.empty()) continue;
        std::vector<glm::vec3> moved = mesh.positions;
        for (std::size_t i = 0; i < moved.size(); ++i)
            moved[i] += target.positions[i];
        target.normals = flat_normals(moved);
        for (std::size_t i = 0; i < moved.size(); ++i)
            target.normals[i] -= mesh.normals[i];
    }
}

void compute_tangents(Mesh& mesh, std::uint32_t uv_set) {
    RAMBLA_ASSERT(mesh.topology == Topology::triangles, "only triangles have tangents");
    RAMBLA_ASSERT(mesh.normals.size() == mesh.positions.size(), "tangents are perpendicular to normals");
    mesh.tangents.clear();
    for (MorphTarget& target : mesh.morphs)
        target.tangents.clear();
    const std::vector<glm::vec2>& uv = uv_set == 0 ? mesh.uv0 : mesh.uv1;
    std::vector<Chart> charts(mesh.indices.size() / 3);
    if (!uv.empty())
        for (std::size_t t = 0; t < charts.size(); ++t)
            charts[t] =
                chart_of(corners(mesh.positions, &mesh.indices[3 * t]), corners(uv, &mesh.indices[3 * t]));
    const std::vector<Handedness> handedness = split_mirrored_vertices(mesh, charts);

    std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3{0.0f});
    for (std::size_t t = 0; t < charts.size(); ++t) {
        const auto p = corners(mesh.positions, &mesh.indices[3 * t]);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = mesh.indices[3 * t + c];
            const glm::vec3 normal = mesh.normals[vertex];
            const float angle = angle_between(p[(c + 1) % 3] - p[c], p[(c + 2) % 3] - p[c]);
            const glm::vec3 in_plane = charts[t].tangent - normal * glm::dot(normal, charts[t].tangent);
            sums[vertex] += angle * direction_or(in_plane, glm::vec3{0.0f});
        }
    }
    mesh.tangents.resize(mesh.positions.size());
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const glm::vec3 normal = mesh.normals[v];
        const glm::vec3 perpendicular = any_perpendicular(normal);
        const glm::vec3 sum = direction_or(sums[v], perpendicular);
        const glm::vec3 tangent = direction_or(sum - normal * glm::dot(normal, sum), perpendicular);
        mesh.tangents[v] = {tangent, handedness[v] == Handedness::mirrored ? -1.0f : 1.0f};
    }
}

}  // namespace rambla::assets
