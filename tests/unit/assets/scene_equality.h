#pragma once

#include "assets/scene.h"

namespace rambla::assets::test {

/// Expects that `back` is what an export of `scene` and an import of that must give: equal to the bit, but
/// for
/// - weights of skinned vertices, which the importer makes sum to 1 anew, and joints without weight;
/// - meshes by their use: those that no model shows are not written, the others may be numbered anew;
/// - skeletons without joints and clips without channels, which are not written.
void expect_equal(const Scene& scene, const Scene& back);

}  // namespace rambla::assets::test
