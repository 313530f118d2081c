#pragma once

#include <cstdint>
#include <string>

#include "assets/scene.h"

namespace rambla::assets::generate {

/// The air that lights up about a lamp: one ball that shines and hides nothing.
/// @param radiance       of the lamp's glass
/// @param optical_depth  through its middle
/// @return  index of the emitter
std::uint32_t add_glow(Scene& scene, const std::string& name, glm::vec3 radiance, float radius_m,
                       float optical_depth);

/// What rises from a chimney and drifts away along +x. @return  index of the emitter
std::uint32_t add_smoke(Scene& scene);

/// What rises from the sewers through a cover. @return  index of the emitter
std::uint32_t add_vapour(Scene& scene);

/// Adds a node that emits, under `parent`, its axes those of the world.
/// @param rotation  of the parent
void add_emitter_node(Scene& scene, std::uint32_t emitter, std::uint32_t parent, glm::vec3 at_m,
                      const glm::quat& rotation);

}  // namespace rambla::assets::generate
