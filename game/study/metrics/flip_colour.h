#pragma once

#include <glm/glm.hpp>

/// Colours as ꟻLIP compares them. Andersson et al. 2020, on its colour pipeline.
namespace rambla::game::study::flip {

/// The opponent space in which the eye's blur acts, but for scale and offset: luminance, red-green and
/// blue-yellow as (Y, X − Y, Y − Z), each of X, Y, Z relative to white. The paper's YyCxCz are
/// (116 Y − 16, 500 (X − Y), 200 (Y − Z)); a blur whose weights sum to 1 leaves factors and offset as they
/// are, and going back takes them off again, so that nothing is lost by never applying them.
/// @param rgb  linear Rec. 709
[[nodiscard]] glm::vec3 opponent_from_rgb(glm::vec3 rgb);
[[nodiscard]] glm::vec3 rgb_from_opponent(glm::vec3 opponent);

/// L*a*b* with a* and b* less in the dark, the Hunt effect: (L*, 0.01 L* a*, 0.01 L* b*).
/// @param rgb  linear Rec. 709 in [0, 1]
[[nodiscard]] glm::vec3 hunt_lab_from_rgb(glm::vec3 rgb);

/// Difference of two colours of hunt_lab_from_rgb(), 0 to 1: HyAB (Abasi et al. 2020), to
/// the power of 0.7, and mapped so that the lower 40 % of the range take 95 % of the result.
[[nodiscard]] float colour_difference(glm::vec3 a, glm::vec3 b);

}  // namespace rambla::game::study::flip
