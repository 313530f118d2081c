#pragma once

#include "assets/environment.h"
#include "assets/scene.h"

namespace rambla::assets {

/// Adds the sun of an environment as a directional light on a root node of its own, since glTF knows lights
/// but no surroundings. Nothing, where there is no sun.
void add_sun(Scene& scene, const Environment& environment);

}  // namespace rambla::assets
