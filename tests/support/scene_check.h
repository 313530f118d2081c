#pragma once

#include <string>

#include "assets/scene.h"

namespace rambla::assets::test {

/// What is wrong with a scene that an importer made, the first thing found; empty for a sound one. Indices
/// must be valid, columns of one length, numbers finite, directions of unit length, keys in order.
[[nodiscard]] std::string problem_of(const Scene& scene);

}  // namespace rambla::assets::test
