#pragma once

#include "assets/place.h"

namespace rambla::assets {

/// Plain scene for comparison with other engines: 400 boxes on a plane, sun, 16 coloured point lights.
[[nodiscard]] Place generate_blocks();

}  // namespace rambla::assets
