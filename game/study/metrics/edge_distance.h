#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace rambla::game::study {

/// Euclidean distance from every pixel's centre to that of the nearest pixel of an edge, exact.
/// @param size_px  width and height
/// @param is_edge  per pixel, row-major, not 0 on an edge; asserted to be width · height
/// @return         pixels, row-major; 0 on an edge, infinity everywhere when there is none
/// In two passes of linear time: along columns, then the lower envelope of one parabola per column along each
/// row. Meijster, Roerdink and Hesselink 2000; Felzenszwalb and Huttenlocher 2012.
[[nodiscard]] std::vector<double> edge_distance_px(glm::uvec2 size_px, std::span<const std::uint8_t> is_edge);

}  // namespace rambla::game::study
