#pragma once

#include <vector>

#include "assets/scene.h"

namespace rambla::test {

/// Adds a clip that lasts as long as its channels.
void add_clip(assets::Scene& scene, const char* name, std::vector<assets::Channel> channels);

/// A square prism of 0.2 m and two metres up from the origin, with an elbow in the middle: a skeleton of two
/// joints, shoulder and elbow, nodes 0 and 1. Its mesh is node 2's, which stands far away, as it may. Clip 0,
/// "bend", turns the elbow by 90° about z in a second and stays; clip 1, "sway", moves the shoulder to and
/// fro along x.
[[nodiscard]] assets::Scene bending_arm();

}  // namespace rambla::test
