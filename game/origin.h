#pragma once

#include <string>

#include "systems/components.h"

namespace rambla::game {

/// Reads `X,Y,Z` in metres from (0,0,0). @throws std::invalid_argument  saying what was found and expected
[[nodiscard]] systems::WorldPosition parse_origin(const std::string& text);

}  // namespace rambla::game
