#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

namespace rambla::assets {

using TriangleCorners = std::array<glm::dvec3, 3>;

/// The point of a triangle that is nearest to something.
struct PointOnTriangle {
    glm::dvec3 weights{1.0, 0.0, 0.0};  ///< barycentric, ≥ 0, of sum 1
    double distance = std::numeric_limits<double>::infinity();
};

/// Nearest point of a triangle, which may be degenerate: a segment or a point. Ericson 2005, section 5.1.5.
[[nodiscard]] PointOnTriangle nearest_on_triangle(glm::dvec3 point, const TriangleCorners& triangle);

struct PointOnSurface {
    std::uint32_t triangle = 0xffffffffu;
    PointOnTriangle place;
};

/// Triangles in a tree of boxes, to be asked for what is nearest to a point. Refers to the spans that it is
/// made of.
class Surface {
public:
    /// @param indices  triangle list of valid indices of finite positions
    Surface(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

    /// Nearest point of the surface; of an empty surface, triangle 0xffffffff at infinite distance.
    [[nodiscard]] PointOnSurface nearest(glm::dvec3 point) const;

    [[nodiscard]] TriangleCorners corners(std::uint32_t triangle) const;
    [[nodiscard]] std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(order_.size()); }
    [[nodiscard]] std::span<const glm::vec3> positions() const { return positions_; }
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return indices_; }

private:
    /// A leaf where count > 0: `first` in order_; else the children are the next node and node `first`.
    struct Node {
        glm::vec3 min{0.0f};
        glm::vec3 max{0.0f};
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };

    void build(std::uint32_t first, std::uint32_t count);

    std::span<const glm::vec3> positions_;
    std::span<const std::uint32_t> indices_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace rambla::assets
