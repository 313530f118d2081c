#include <algorithm>
#include <cmath>

#include "assets/process/deviation.h"

namespace rambla::assets {

namespace {

template <class T>
T interpolated(const std::vector<T>& column, const std::uint32_t* triangle, glm::dvec3 weights) {
    const glm::vec3 w{weights};
    return w.x * column[triangle[0]] + w.y * column[triangle[1]] + w.z * column[triangle[2]];
}

double angle_between(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double area(const TriangleCorners& t) {
    return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
}

}  // namespace

AttributeDeviation attribute_deviation(const Mesh& mesh, const Surface& coarse) {
    if (coarse.triangle_count() == 0 || (mesh.normals.empty() && mesh.uv0.empty())) return {};
    const Surface fine{mesh.positions, mesh.indices};
    double total_area = 0.0;
    for (std::uint32_t t = 0; t < fine.triangle_count(); ++t)
        total_area += area(fine.corners(t));
    if (!(total_area > 0.0)) return {};

    constexpr double k_wanted_samples = 4096.0;
    constexpr double k_most_rows = 32.0;
    double squared_deg = 0.0;
    double squared_uv = 0.0;
    for (std::uint32_t t = 0; t < fine.triangle_count(); ++t) {
        const TriangleCorners corners = fine.corners(t);
        const double share = area(corners) / total_area;
        const int rows =
            static_cast<int>(std::clamp(std::ceil(std::sqrt(share * k_wanted_samples)), 1.0, k_most_rows));
        const double weight = share / (rows * rows);
        const std::uint32_t* const here = &mesh.indices[std::size_t{3} * t];
        // Centres of the rows² congruent triangles that lines parallel to the edges make.
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < 2 * (rows - i) - 1; ++j) {
                const bool upright = j % 2 == 0;
                const double a = (i + (upright ? 1.0 : 2.0) / 3.0) / rows;
                const double b = (j / 2 + (upright ? 1.0 : 2.0) / 3.0) / rows;
                const glm::dvec3 weights{1.0 - a - b, a, b};
                const PointOnSurface found =
                    coarse.nearest(weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2]);
                const std::uint32_t* const there = &coarse.indices()[std::size_t{3} * found.triangle];
                if (!mesh.normals.empty()) {
                    const double deg =
                        glm::degrees(angle_between(interpolated(mesh.normals, here, weights),
                                                   interpolated(mesh.normals, there, found.place.weights)));
                    squared_deg += weight * deg * deg;
                }
                if (!mesh.uv0.empty()) {
                    const glm::dvec2 apart = interpolated(mesh.uv0, here, weights) -
                                             interpolated(mesh.uv0, there, found.place.weights);
                    squared_uv += weight * glm::dot(apart, apart);
                }
            }
    }
    return {std::sqrt(squared_deg), std::sqrt(squared_uv)};
}

}  // namespace rambla::assets
