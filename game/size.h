#pragma once

#include <glm/glm.hpp>
#include <string>

namespace rambla::game {

/// Reads `WIDTHxHEIGHT` in pixels, each from 16 to 16384. @throws std::invalid_argument  saying what was
/// found
[[nodiscard]] glm::uvec2 parse_size(const std::string& text);

}  // namespace rambla::game
