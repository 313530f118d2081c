#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/shaders/shared/light_hull.h"
#include "systems/frame.h"

namespace rambla::render {

/// Convex solids of few faces that hold all that a local light reaches. Their faces, not only their vertices,
/// lie outside of it:
///
///        ╱‾‾‾‾╲                   ╭─────╮ R         lid: touches the sphere on the axis
///      ╱        ╲                ╱   │   ╲          bevel: touches it at θ/2
///     │     ·──R─│              ╱    │    ╲
///      ╲        ╱               ╲    │    ╱         rim: at R/cos(θ/2) in the direction θ, hence
///        ╲____╱                   ╲  │θ ╱                2·R·sin(θ/2) from the axis
///                                   ╲│╱
///      sphere                        ·              cone: of eight sides
///
/// Up to θ = 60° the rim is no wider than the sphere, and the cone the tighter of the two.
enum class HullShape : std::uint8_t {
    sphere,  ///< an icosahedron with each face divided in four; of point lights and wide spots
    cone     ///< of spots of up to 60° from the axis
};
inline constexpr std::size_t k_hull_shapes = 2;

/// What hulls of one shape have in common.
struct HullMesh {
    std::vector<glm::vec4> vertices;     ///< shares: that vertex of a hull lies at origin + axes · shares
    std::vector<std::uint32_t> indices;  ///< triangles, anticlockwise where seen from outside
};
[[nodiscard]] HullMesh hull_mesh(HullShape shape);

struct Hull {
    HullShape shape = HullShape::sphere;
    shared::LightHull place;  ///< columns of `axes`: x, y, z of a sphere; side, side, rim, lid of a cone
};

/// @param light  place finite, radius > 0, which counts up to k_farthest_light_m; a direction that is not of
///               unit length is none, and the light a point
/// @param row    of the light in the Frame
[[nodiscard]] Hull light_hull(const systems::FrameLight& light, std::uint32_t row);

/// Whether the near plane, as far as the view sees it, may cut the hull: then front faces have holes, and
/// only its back faces cover all that it holds. Never false where it does cut; true, too, where the eye is
/// nearer to the hull than to the near plane's corners.
[[nodiscard]] bool reaches_near_plane(const systems::FrameView& view, const Hull& hull);

}  // namespace rambla::render
