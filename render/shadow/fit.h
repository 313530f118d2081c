#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "assets/bounds.h"
#include "systems/frame.h"

namespace rambla::render::shadow {

/// What the sun's map has to cover. World is camera-relative, as in the Frame.
struct FitInput {
    systems::FrameView view;
    glm::vec3 direction_to_sun{0.0f, 1.0f, 0.0f};  ///< unit length
    float distance_m = 160.0f;  ///< shadows are looked for up to this distance along the view
    assets::Bounds receivers;   ///< box of all that is visible; empty: nothing is
    std::uint32_t size_texels = 2048;
};

/// An orthographic light view.
struct SunFit {
    glm::mat4 clip_from_world{1.0f};  ///< depth 1 nearest to the sun, 0 farthest; always invertible
    glm::vec2 texel_m{1.0f};          ///< edges of a texel
    float depth_m = 1.0f;             ///< depth range
    bool empty = true;                ///< no shadow can be seen: no receiver, no caster, or no finite input
};

/// Corners of the part of the view between its near plane and `distance_m` along the view, in world axes:
/// first the four of the near side, then those of the far side, both in the order −−, +−, ++, −+ of clip
/// space.
[[nodiscard]] std::array<glm::vec3, 8> frustum_slice(const systems::FrameView& view, float distance_m);

/// Fits the map to frustum slice ∩ receivers ∩ casters (Brabec et al. 2002): as few metres per texel as what
/// is seen allows. Only the extent across the light is cut to the casters; the depth range covers the
/// receivers, and casters nearer to the sun are to be clamped to it.
///
/// The map's columns run along the view's direction as the sun sees it, so that a street fills it. Its corner
/// lies on a grid fixed in the world and its texel size changes in steps of 2^(1/8): moving the eye without
/// turning it moves the map by whole texels, and resting shadows rest.
///
/// Any input gives an invertible matrix: extents are at least a millimetre, and a view along the light takes
/// the view's up direction instead of its own.
[[nodiscard]] SunFit fit_sun_map(const FitInput& input, const systems::CasterColumns& casters);

}  // namespace rambla::render::shadow
