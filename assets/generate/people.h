#pragma once

#include <glm/glm.hpp>

#include "assets/generate/draws.h"
#include "assets/generate/palette.h"

namespace rambla::assets::generate {

/// What tells people apart. Colours are linear albedo.
struct Looks {
    float height_m = 1.72f;
    float girth = 1.0f;     ///< of trunk and limbs, relative
    bool shoulders = true;  ///< broader shoulders, narrower hips
    bool skirt = false;
    bool long_hair = false;
    bool hat = false;
    bool bag = false;
    bool bare_arms = true;   ///< short sleeves
    bool bare_legs = false;  ///< shorts or bare under a skirt
    glm::vec3 skin{0.6f, 0.42f, 0.32f};
    glm::vec3 hair{0.05f, 0.035f, 0.025f};
    glm::vec3 top{0.5f};
    glm::vec3 bottom{0.1f};
    glm::vec3 shoes{0.05f};
    glm::vec3 extra{0.4f, 0.25f, 0.15f};  ///< bag, hat
};

/// Looks of the n-th prototype: bodies differ by n, colours by the draws.
[[nodiscard]] Looks draw_looks(std::uint32_t number, Draws& draws);

/// Adds a person to the scene who stands upright on y = 0 and faces −z: node `walker` with children `torso`
/// (with `head`, `arm_l` → `forearm_l`, …) and `leg_l` → `shin_l`, …. Node origins are the joints: a turn
/// about x swings the limb. It is no root. Returns the node.
std::uint32_t add_person(Scene& scene, const Looks& looks, const Scheme& scheme);

}  // namespace rambla::assets::generate
