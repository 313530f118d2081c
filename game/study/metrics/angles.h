#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>

namespace rambla::game::study {

/// Angle between two directions of any length, 0 to π: atan2(|a × b|, a · b). Unlike acos of the dot product,
/// which loses half of its digits near 0 and π, it is exact to rounding for every angle.
/// Kahan 2006, "How Futile are Mindless Assessments of Roundoff in Floating-Point Computation?".
/// @return  radians; 0 when a direction is zero
[[nodiscard]] double angle_rad(glm::dvec3 a, glm::dvec3 b);

/// How far the directions of a picture are from those of the reference.
struct Angles {
    double p50_deg = 0.0;  ///< all three 0 when nothing is counted
    double p99_deg = 0.0;
    double max_deg = 0.0;
    std::size_t counted = 0;
    std::size_t not_counted = 0;  ///< pixels where one of the directions is zero, infinite or NaN
};

/// @param reference, test  a direction per pixel (normals, reflected rays), of any length; need not be unit
/// @throws std::invalid_argument saying both counts when they differ
/// Symmetric.
[[nodiscard]] Angles angles_between(std::span<const glm::vec3> reference, std::span<const glm::vec3> test);

}  // namespace rambla::game::study
