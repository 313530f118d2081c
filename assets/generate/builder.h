#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "assets/generate/surface.h"
#include "assets/scene.h"

namespace rambla::assets::generate {

/// Right-handed orthonormal frame in which geometry is described: x to the right, y up, z out of a wall.
struct Frame {
    glm::vec3 origin_m{0.0f};
    glm::vec3 right{1.0f, 0.0f, 0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    glm::vec3 out{0.0f, 0.0f, 1.0f};

    [[nodiscard]] glm::vec3 direction(glm::vec3 v) const { return right * v.x + up * v.y + out * v.z; }
    [[nodiscard]] glm::vec3 point(glm::vec3 p) const { return origin_m + direction(p); }
    /// The inverse of point().
    [[nodiscard]] glm::vec3 local(glm::vec3 p) const {
        const glm::vec3 d = p - origin_m;
        return {glm::dot(d, right), glm::dot(d, up), glm::dot(d, out)};
    }
    /// The frame that `child`, given in this frame, is in the space that this frame is given in.
    [[nodiscard]] Frame operator*(const Frame& child) const {
        return {point(child.origin_m), direction(child.right), direction(child.up), direction(child.out)};
    }
};

/// The frame at `origin` whose x axis is turned by `angle_rad` from x towards −z (counter-clockwise seen from
/// above).
[[nodiscard]] Frame turned(glm::vec3 origin_m, float angle_rad);

/// Sides of a box.
enum : std::uint32_t {
    k_side_left = 1,
    k_side_right = 2,
    k_side_bottom = 4,
    k_side_top = 8,
    k_side_back = 16,
    k_side_front = 32,
    k_all_sides = 63
};

/// One cross-section of a lofted tube: an ellipse about `centre_m` in the plane of the two axes.
struct Ring {
    glm::vec3 centre_m{0.0f};
    glm::vec3 axis_a{1.0f, 0.0f, 0.0f};  ///< half axes, metres, perpendicular to each other
    glm::vec3 axis_b{0.0f, 0.0f, 1.0f};
};

/// Collects textured faces, one mesh per surface and group. Texture coordinates are metric (see
/// metres_per_repeat) unless given. Tangents point along increasing u, with w = +1: the bitangent points up
/// the image (decreasing v).
class Builder {
public:
    Frame frame;              ///< all points below are given in this frame
    glm::vec4 colour{1.0f};   ///< of the vertices made from now on
    std::uint32_t group = 0;  ///< of the faces made from now on: panes of different groups never share a mesh
    float stretch = 1.0f;     ///< of metric texture coordinates: repeats are this much larger

    /// A planar quadrilateral, corners counter-clockwise from its front; u runs along p0→p1.
    void face(Surface surface, glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, glm::vec3 p3);
    /// The same with texture coordinates of its own: `low` at p0 (bottom left), `high` at p2 (top right).
    void picture(Surface surface, glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, glm::vec3 p3, glm::vec2 low,
                 glm::vec2 high);
    /// A rectangle in the plane z.
    void panel(Surface surface, glm::vec2 min, glm::vec2 max, float z);
    void box(Surface surface, glm::vec3 min, glm::vec3 max, std::uint32_t sides = k_all_sides);
    /// A planar convex polygon, counter-clockwise from its front; u runs along x, or along z where the plane
    /// is x's.
    void polygon(Surface surface, std::span<const glm::vec3> corners);
    /// A profile (z, y), rising from below, drawn along x. Ends are sheared by mitre · z outwards, so that
    /// neighbours at a corner of exterior angle φ meet for mitre = tan(φ/2); an end with mitre 0 is capped
    /// when `caps`.
    void moulding(Surface surface, std::span<const glm::vec2> profile, float x0, float x1, float mitre0,
                  float mitre1, bool caps = true);
    /// A tube through rings with smooth normals; ends are closed by flat fans when asked for.
    void tube(Surface surface, std::span<const Ring> rings, int sides, bool close_first, bool close_last);
    /// A sheet of rows × columns points with normals smooth below `crease_rad` between neighbouring cells.
    /// @param surfaces  one per cell, row-major; @param points row-major; front is (next column) × (next row)
    void sheet(std::span<const glm::vec3> points, std::size_t columns, std::span<const Surface> surfaces,
               float crease_rad);
    /// A single vertex quad whose shading normals are given, for leaves.
    void card(Surface surface, const std::array<glm::vec3, 4>& corners,
              const std::array<glm::vec3, 4>& normals, glm::vec2 low, glm::vec2 high);

    /// A finished mesh with what it is made of.
    struct Part {
        Surface surface = Surface::wall;
        std::uint32_t group = 0;
        Mesh mesh;
    };
    /// Hands out what was built, ordered by surface and group, with bounds; the builder is empty afterwards.
    [[nodiscard]] std::vector<Part> take(const std::string& name);

private:
    struct Vertex {
        glm::vec3 position, normal, tangent;
        glm::vec2 uv;
    };
    Mesh& mesh(Surface surface);
    void emit(Mesh& into, const Vertex& vertex);
    void emit_quad(Surface surface, const std::array<glm::vec3, 4>& corners,
                   const std::array<glm::vec3, 4>& normals, glm::vec3 u_axis,
                   const std::array<glm::vec2, 4>& uv);

    std::vector<Part> parts_;
};

/// A frame for the time of a scope.
class InFrame {
public:
    InFrame(Builder& builder, const Frame& child) : builder_{builder}, outer_{builder.frame} {
        builder.frame = outer_ * child;
    }
    ~InFrame() { builder_.frame = outer_; }
    InFrame(const InFrame&) = delete;
    InFrame& operator=(const InFrame&) = delete;

private:
    Builder& builder_;
    Frame outer_;
};

}  // namespace rambla::assets::generate
