#pragma once

#include <algorithm>
#include <glm/glm.hpp>

#include "assets/daylight.h"
#include "assets/scene.h"

namespace rambla::assets::generate {

/// How much of a city's own light burns at a time of day. Shares are of all windows, or of all shops; who is
/// at home at one moment of the night is among those at home at any moment with a larger share.
struct Evening {
    float lamps =
        0.0f;  ///< of street lamps' full power: 0 while the sun is higher than 4°, 1 from 2° below on
    float warm_windows = 0.0f;    ///< lit by lamps
    float blue_windows = 0.0f;    ///< lit by a television
    float bright_shops = 1.0f;    ///< shop windows with their lights on
    float lamps_at_shops = 0.0f;  ///< shops with a lamp outside that burns

    /// From what something is by day to what it is at night, as the lamps go on.
    [[nodiscard]] glm::vec3 between(glm::vec3 day, glm::vec3 night) const {
        return glm::mix(day, night, lamps);
    }
};

[[nodiscard]] Evening evening_at(TimeOfDay time);

/// Colours of lamps of 2700 and 3000 K as a camera that is balanced for 4000 K records them, the brightest
/// channel 1: linear Rec. 709 of Planck's radiator at the one temperature over that at the other.
inline constexpr glm::vec3 k_light_2700k{1.0f, 0.64f, 0.26f};
inline constexpr glm::vec3 k_light_3000k{1.0f, 0.73f, 0.41f};

/// Adds a lamp's light to the scene and returns its index.
std::uint32_t add_lamp(Scene& scene, const char* name, LightKind kind, glm::vec3 colour, float intensity,
                       float range_m);

}  // namespace rambla::assets::generate
