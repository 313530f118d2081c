#include "assets/generate/builder.h"

#include <algorithm>
#include <cmath>

namespace rambla::assets::generate {

namespace {

constexpr float k_two_pi = 6.2831853f;

/// Some unit vector perpendicular to a unit normal, as close to `wanted` as possible.
glm::vec3 perpendicular(glm::vec3 wanted, glm::vec3 normal) {
    glm::vec3 along = wanted - normal * glm::dot(wanted, normal);
    if (glm::dot(along, along) < 1e-12f)
        along = std::abs(normal.y) < 0.9f ? glm::cross(glm::vec3{0.0f, 1.0f, 0.0f}, normal)
                                          : glm::cross(normal, glm::vec3{1.0f, 0.0f, 0.0f});
    return glm::normalize(along);
}

}  // namespace

Frame turned(glm::vec3 origin_m, float angle_rad) {
    const float c = std::cos(angle_rad);
    const float s = std::sin(angle_rad);
    return {origin_m, {c, 0.0f, -s}, {0.0f, 1.0f, 0.0f}, {s, 0.0f, c}};
}

Mesh& Builder::mesh(Surface surface) {
    const std::uint32_t own = is_pane(surface) ? group : 0;
    for (Part& part : parts_)
        if (part.surface == surface && part.group == own) return part.mesh;
    return parts_.emplace_back(Part{surface, own, {}}).mesh;
}

void Builder::emit(Mesh& into, const Vertex& vertex) {
    const glm::vec3 position = frame.point(vertex.position);
    const glm::vec3 normal = glm::normalize(frame.direction(vertex.normal));
    const glm::vec3 tangent = perpendicular(frame.direction(vertex.tangent), normal);
    into.positions.push_back(position);
    into.normals.push_back(normal);
    into.tangents.emplace_back(tangent, 1.0f);
    into.uv0.push_back(vertex.uv);
    into.colours.push_back(colour);
    into.bounds.expand(position);
}

void Builder::emit_quad(Surface surface, const std::array<glm::vec3, 4>& corners,
                        const std::array<glm::vec3, 4>& normals, glm::vec3 u_axis,
                        const std::array<glm::vec2, 4>& uv) {
    Mesh& into = mesh(surface);
    const auto first = static_cast<std::uint32_t>(into.positions.size());
    for (std::size_t i = 0; i < 4; ++i)
        emit(into, {corners[i], normals[i], u_axis, uv[i]});
    // Quadrilaterals may have two corners in one place: then one of the triangles is nothing.
    for (const std::uint32_t i : {1u, 2u}) {
        if (corners[0] == corners[i] || corners[i] == corners[i + 1] || corners[i + 1] == corners[0])
            continue;
        for (const std::uint32_t corner : {0u, i, i + 1})
            into.indices.push_back(first + corner);
    }
}

void Builder::face(Surface surface, glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, glm::vec3 p3) {
    const glm::vec3 cross = glm::cross(p2 - p0, p3 - p1);  // twice the area: right for trapezoids too
    const float area = glm::length(cross);
    if (area < 1e-8f) return;
    const glm::vec3 normal = cross / area;
    const glm::vec3 u = perpendicular(p1 - p0, normal);
    const glm::vec3 v = glm::cross(normal, u);
    const float scale = 1.0f / (stretch * metres_per_repeat(surface));
    const auto uv = [&](glm::vec3 p) {
        return glm::vec2{glm::dot(p, u), -glm::dot(p, v)} * scale;
    };
    emit_quad(surface, {p0, p1, p2, p3}, {normal, normal, normal, normal}, u,
              {uv(p0), uv(p1), uv(p2), uv(p3)});
}

void Builder::picture(Surface surface, glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, glm::vec3 p3, glm::vec2 low,
                      glm::vec2 high) {
    const glm::vec3 normal = glm::normalize(glm::cross(p2 - p0, p3 - p1));
    const std::array<glm::vec2, 4> uv{low, glm::vec2{high.x, low.y}, high, glm::vec2{low.x, high.y}};
    emit_quad(surface, {p0, p1, p2, p3}, {normal, normal, normal, normal}, high.x < low.x ? p0 - p1 : p1 - p0,
              uv);
}

void Builder::panel(Surface surface, glm::vec2 min, glm::vec2 max, float z) {
    face(surface, {min.x, min.y, z}, {max.x, min.y, z}, {max.x, max.y, z}, {min.x, max.y, z});
}

void Builder::box(Surface surface, glm::vec3 a, glm::vec3 b, std::uint32_t sides) {
    if (sides & k_side_front)
        face(surface, {a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z});
    if (sides & k_side_back)
        face(surface, {b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z});
    if (sides & k_side_left)
        face(surface, {a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z});
    if (sides & k_side_right)
        face(surface, {b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z});
    if (sides & k_side_top) face(surface, {a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z});
    if (sides & k_side_bottom)
        face(surface, {a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z});
}

void Builder::polygon(Surface surface, std::span<const glm::vec3> corners) {
    glm::vec3 normal{0.0f};
    for (std::size_t i = 2; i < corners.size(); ++i)
        normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    normal = glm::normalize(normal);
    const bool sideways = std::abs(normal.x) > 0.9f;
    const glm::vec3 u =
        perpendicular(sideways ? glm::vec3{0.0f, 0.0f, 1.0f} : glm::vec3{1.0f, 0.0f, 0.0f}, normal);
    const glm::vec3 v = glm::cross(normal, u);
    Mesh& into = mesh(surface);
    const auto first = static_cast<std::uint32_t>(into.positions.size());
    const float scale = 1.0f / (stretch * metres_per_repeat(surface));
    for (const glm::vec3& p : corners)
        emit(into, {p, normal, u, glm::vec2{glm::dot(p, u), -glm::dot(p, v)} * scale});
    for (std::uint32_t i = 2; i < corners.size(); ++i)
        for (const std::uint32_t corner : {0u, i - 1, i})
            into.indices.push_back(first + corner);
}

void Builder::moulding(Surface surface, std::span<const glm::vec2> profile, float x0, float x1, float mitre0,
                       float mitre1, bool caps) {
    const auto left = [&](glm::vec2 p) {
        return glm::vec3{x0 - mitre0 * p.x, p.y, p.x};
    };
    const auto right = [&](glm::vec2 p) {
        return glm::vec3{x1 + mitre1 * p.x, p.y, p.x};
    };
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const glm::vec2 a = profile[i - 1];
        const glm::vec2 b = profile[i];
        face(surface, left(a), right(a), right(b), left(b));
        if (!caps || a.y == b.y) continue;
        const glm::vec2 wall_a{0.0f, a.y};
        const glm::vec2 wall_b{0.0f, b.y};
        if (mitre0 == 0.0f) face(surface, left(wall_a), left(a), left(b), left(wall_b));
        if (mitre1 == 0.0f) face(surface, right(a), right(wall_a), right(wall_b), right(b));
    }
}

void Builder::tube(Surface surface, std::span<const Ring> rings, int sides, bool close_first,
                   bool close_last) {
    Mesh& into = mesh(surface);
    const auto first = static_cast<std::uint32_t>(into.positions.size());
    const float scale = 1.0f / (stretch * metres_per_repeat(surface));
    // The same number of texture repeats all the way up, whole so that the seam closes.
    const float girth = k_two_pi * 0.5f * (glm::length(rings[0].axis_a) + glm::length(rings[0].axis_b));
    const float repeats = std::max(1.0f, std::round(girth * scale));
    float along = 0.0f;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const Ring& ring = rings[r];
        const Ring& below = rings[r == 0 ? 0 : r - 1];
        const Ring& above = rings[std::min(r + 1, rings.size() - 1)];
        if (r > 0) along += glm::length(ring.centre_m - below.centre_m);
        for (int i = 0; i <= sides; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(sides);
            const float angle = i == sides ? 0.0f : k_two_pi * share;
            const float c = std::cos(angle);
            const float s = std::sin(angle);
            const auto at = [&](const Ring& q) {
                return q.centre_m + q.axis_a * c + q.axis_b * s;
            };
            const glm::vec3 around = ring.axis_b * c - ring.axis_a * s;
            glm::vec3 normal = glm::cross(at(above) - at(below), around);
            // Counter-clockwise from above in the axes' own plane: the outside is where the radius points.
            const glm::vec3 radius = ring.axis_a * c + ring.axis_b * s;
            if (glm::dot(normal, normal) < 1e-14f) normal = radius;
            if (glm::dot(normal, radius) < 0.0f) normal = -normal;
            const bool mirrored =
                glm::dot(glm::cross(around, above.centre_m - below.centre_m), radius) < 0.0f;
            const float u = (mirrored ? 1.0f - share : share) * repeats;
            emit(into, {at(ring), glm::normalize(normal), mirrored ? -around : around, {u, -along * scale}});
        }
    }
    const auto row = static_cast<std::uint32_t>(sides + 1);
    const glm::vec3 axis = rings.back().centre_m - rings.front().centre_m;
    const bool inverted = glm::dot(glm::cross(rings[0].axis_a, rings[0].axis_b), axis) < 0.0f;
    for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = first + r * row + i;
            const std::uint32_t b = a + 1;
            const std::uint32_t c = b + row;
            const std::uint32_t d = a + row;
            if (inverted)
                for (const std::uint32_t index : {b, a, d, b, d, c})
                    into.indices.push_back(index);
            else
                for (const std::uint32_t index : {a, b, c, a, c, d})
                    into.indices.push_back(index);
        }
    }
    const auto close = [&](const Ring& ring, bool outwards) {
        std::vector<glm::vec3> corners;
        for (int i = 0; i < sides; ++i) {
            const float angle = k_two_pi * static_cast<float>(i) / static_cast<float>(sides);
            corners.push_back(ring.centre_m + ring.axis_a * std::cos(angle) + ring.axis_b * std::sin(angle));
        }
        if (outwards == inverted) std::reverse(corners.begin(), corners.end());
        polygon(surface, corners);
    };
    if (close_first) close(rings.front(), false);
    if (close_last) close(rings.back(), true);
}

void Builder::card(Surface surface, const std::array<glm::vec3, 4>& corners,
                   const std::array<glm::vec3, 4>& normals, glm::vec2 low, glm::vec2 high) {
    emit_quad(surface, corners, normals, corners[1] - corners[0],
              {low, glm::vec2{high.x, low.y}, high, glm::vec2{low.x, high.y}});
}

std::vector<Builder::Part> Builder::take(const std::string& name) {
    std::vector<Part> parts = std::move(parts_);
    parts_.clear();
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
        return a.surface != b.surface ? a.surface < b.surface : a.group < b.group;
    });
    for (Part& part : parts) {
        part.mesh.name = name;
        const auto white = [](glm::vec4 c) {
            return c == glm::vec4{1.0f};
        };
        if (std::all_of(part.mesh.colours.begin(), part.mesh.colours.end(), white)) part.mesh.colours.clear();
    }
    return parts;
}

}  // namespace rambla::assets::generate
