#pragma once

#include "assets/place.h"

namespace rambla::assets {

/// Plain scene for comparison with other engines: 10 000 movers of 24 triangles on a plane, sun.
[[nodiscard]] Place generate_agents();

}  // namespace rambla::assets
