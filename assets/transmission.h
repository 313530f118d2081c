#pragma once

#include "assets/scene.h"

namespace rambla::assets {

/// Makes materials that transmit light blend, for renderers that know no other glass: alpha becomes
/// alpha · (1 − 0.9 · transmission), so that some of the surface remains to carry its highlights.
void blend_transmission(Scene& scene);

}  // namespace rambla::assets
