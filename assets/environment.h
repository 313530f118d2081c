#pragma once

#include <glm/glm.hpp>

namespace rambla::assets {

/// Sun and sky. Radiance 1.0 is diffuse white under the noon sun; illuminance π gives a white Lambert surface
/// that faces the sun radiance 1.0.
struct Environment {
    glm::vec3 direction_to_sun{0.0f, 1.0f, 0.0f};  ///< unit length, world axes
    glm::vec3 sun_illuminance{0.0f};               ///< zero means no sun
    glm::vec3 sky_zenith_radiance{0.0f};
    glm::vec3 sky_horizon_radiance{0.0f};
    glm::vec3 ground_radiance{
        0.0f};  ///< what the lower half of the sky sends upwards: light bounced off the ground
    /// Share of the sky's light that houses and trees let through to surfaces, in [0, 1]; what they hide
    /// sends ground_radiance instead. 1 is an open field. Sharp mirrors are not affected: they show the sky.
    float sky_visibility = 1.0f;
};

/// Clear sky at noon in early summer: the light of the street's standard walk and of viewed files that bring
/// none.
[[nodiscard]] inline Environment noon() {
    return {.direction_to_sun = glm::normalize(glm::vec3{0.42f, 0.80f, 0.36f}),
            .sun_illuminance = glm::vec3{3.10f, 2.86f, 2.50f},
            .sky_zenith_radiance = glm::vec3{0.115f, 0.195f, 0.385f},
            .sky_horizon_radiance = glm::vec3{0.40f, 0.47f, 0.55f},
            .ground_radiance = glm::vec3{0.20f, 0.18f, 0.152f}};
}

}  // namespace rambla::assets
