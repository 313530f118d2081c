#include "assets/process/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "assets/assert.h"
#include "assets/mesh_columns.h"
#include "assets/process/columns.h"

namespace rambla::assets {

namespace {

constexpr glm::vec3 k_up{0.0f, 1.0f, 0.0f};

/// Unit vector along v, or `fallback` where v has no direction. In double, where squares of the smallest and
/// of the largest floats neither vanish nor overflow.
glm::vec3 direction_or(glm::dvec3 v, glm::vec3 fallback) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? glm::vec3{v / length} : fallback;
}

glm::dvec3 edge(glm::vec3 from, glm::vec3 to) {
    return glm::dvec3{to} - glm::dvec3{from};
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
        std::fill_n(&normals[i], 3, direction_or(glm::cross(edge(p[0], p[1]), edge(p[0], p[2])), k_up));
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
    const double sign = det > 0.0 ? 1.0 : -1.0;
    const glm::dvec3 along_u = sign * (edge(p[0], p[1]) * double{d2.y} - edge(p[0], p[2]) * double{d1.y});
    return {direction_or(along_u, glm::vec3{0.0f}), det > 0.0};
}

/// Part of v that is perpendicular to a unit vector.
glm::dvec3 across(glm::dvec3 v, glm::dvec3 normal) {
    return v - normal * glm::dot(normal, v);
}

/// Angle of a triangle at its first corner, seen along that corner's normal.
double angle_at(glm::vec3 corner, glm::vec3 one, glm::vec3 other, glm::vec3 normal) {
    const glm::dvec3 a = across(edge(corner, one), normal);
    const glm::dvec3 b = across(edge(corner, other), normal);
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

template <class Column>
std::array<typename Column::value_type, 3> corners(const Column& column, const std::uint32_t* triangle) {
    return {column[triangle[0]], column[triangle[1]], column[triangle[2]]};
}

enum class Handedness : std::uint8_t { unknown, plain, mirrored };

/// Gives every vertex faces of one handedness only. Faces without a chart join whatever their vertices have;
/// vertices of no other faces count as plain.
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
    std::replace(handedness.begin(), handedness.end(), Handedness::unknown, Handedness::plain);
    return handedness;
}

/// Vertices that are one to whoever looks at position, normal, texture coordinates and handedness share a
/// tangent, whether the file gave them one index or several.
std::vector<std::uint32_t> sharing_tangents(const Mesh& mesh, const std::vector<glm::vec2>& uv,
                                            const std::vector<Handedness>& handedness) {
    const std::vector<glm::vec3> places = without_negative_zero(mesh.positions);
    std::vector<ColumnBytes> columns{bytes_of(places), bytes_of(mesh.normals), bytes_of(handedness)};
    if (!uv.empty()) columns.push_back(bytes_of(uv));
    return first_identical(columns, places.size());
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
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3{0.0});
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto p = corners(mesh.positions, &mesh.indices[i]);
        // Twice the area long: the weight comes for free.
        const glm::dvec3 weighted = glm::cross(edge(p[0], p[1]), edge(p[0], p[2]));
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

    const std::vector<std::uint32_t> sharing = sharing_tangents(mesh, uv, handedness);

    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3{0.0});
    for (std::size_t t = 0; t < charts.size(); ++t) {
        if (charts[t].tangent == glm::vec3{0.0f}) continue;
        const auto p = corners(mesh.positions, &mesh.indices[3 * t]);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = mesh.indices[3 * t + c];
            const glm::vec3 normal = mesh.normals[vertex];
            const glm::vec3 in_plane = direction_or(across(charts[t].tangent, normal), glm::vec3{0.0f});
            sums[sharing[vertex]] +=
                angle_at(p[c], p[(c + 1) % 3], p[(c + 2) % 3], normal) * glm::dvec3{in_plane};
        }
    }
    mesh.tangents.resize(mesh.positions.size());
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const glm::vec3 normal = mesh.normals[v];
        const glm::vec3 perpendicular = any_perpendicular(normal);
        const glm::vec3 sum = direction_or(sums[sharing[v]], perpendicular);
        const glm::vec3 tangent = direction_or(across(sum, normal), perpendicular);
        mesh.tangents[v] = {tangent, handedness[v] == Handedness::mirrored ? -1.0f : 1.0f};
    }
}

}  // namespace rambla::assets
