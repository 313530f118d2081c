#pragma once

#include <glm/glm.hpp>
#include <span>

#include "assets/bounds.h"
#include "assets/processed.h"

namespace rambla::assets {

/// The box of points; empty for none.
[[nodiscard]] Bounds bounds_of(std::span<const glm::vec3> points);

/// A ball that holds all points, at most a few per cent larger than the smallest one: Ritter 1990, "An
/// efficient bounding sphere", then shrunk and grown again (Ericson 2005, section 4.3.5). Its float radius is
/// rounded up.
[[nodiscard]] BoundingSphere bounding_sphere_of(std::span<const glm::vec3> points);

}  // namespace rambla::assets
