#pragma once

#include <vector>

#include "assets/generate/facade.h"

namespace rambla::assets::generate {

/// Depth of houses between street and courtyard, in metres.
inline constexpr float k_house_depth_m = 11.0f;
/// What a chamfer cuts off both sides of a block's corner, in metres.
inline constexpr float k_chamfer_m = 5.0f;
/// Length of a corner house along each side of its block, from the chamfer's end, in metres.
inline constexpr float k_corner_side_m = 7.0f;

/// What belongs to a house beside its geometry, in its own space.
struct HouseExtras {
    std::vector<FacadeLight> lights;
    std::vector<glm::vec3> chimneys_m;  ///< the middles of their mouths
};

/// Builds a house between party walls: façade from x = −width/2 to width/2 at z = 0, facing +z, pavement at y
/// = 0, closed by plain walls behind and beside and by a roof.
[[nodiscard]] HouseExtras build_row_house(Builder& builder, float width_m, const FacadeStyle& style,
                                          Draws& draws);

/// Builds a corner house with three façades: the chamfer's middle is at the origin and faces +z.
[[nodiscard]] HouseExtras build_corner_house(Builder& builder, const FacadeStyle& style, Draws& draws);

}  // namespace rambla::assets::generate
