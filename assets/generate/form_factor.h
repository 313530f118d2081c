#pragma once

#include <glm/glm.hpp>
#include <span>

namespace rambla::assets::generate {

/// Most corners of a polygon below.
inline constexpr std::size_t k_most_corners = 15;

/// Irradiance of a point by a polygon that sends the radiance 1 from its front in all directions, over π: the
/// factor from the point to the polygon, exact. What lies below the point's horizon is cut off.
///
///     F = −1/2π · Σ Θᵢ (rᵢ × rᵢ₊₁)/|rᵢ × rᵢ₊₁| · n
///
/// over the edges, with rᵢ from the point to corner i and Θᵢ the angle between rᵢ and rᵢ₊₁.
/// Lambert 1760, "Photometria"; in this form Baum, Rushmeier and Winget 1989, "Improving Radiosity Solutions
/// Through the Use of Analytically Determined Form-Factors", eq. 8.
/// @param corners  3 to k_most_corners of a planar convex polygon, counter-clockwise from its front
/// @param normal   of the receiving surface, unit length
/// @return         [0, 1]; 0 behind the polygon, in its plane beside it, and for one without area
[[nodiscard]] double form_factor(std::span<const glm::dvec3> corners, glm::dvec3 point, glm::dvec3 normal);

}  // namespace rambla::assets::generate
