#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "assets/bounds.h"
#include "assets/daylight.h"
#include "assets/environment.h"
#include "assets/scene.h"
#include "systems/pipeline.h"

namespace rambla::game {

/// A node that the scene shows by default, and where it stands.
struct PlacedNode {
    std::uint32_t node = assets::k_none;
    glm::mat4 scene_from_node{1.0f};
};

/// All nodes under the scene's roots, parents before children.
[[nodiscard]] std::vector<PlacedNode> placed_nodes(const assets::Scene& scene);

/// A camera that circles a point: what the mouse moves in `view`.
struct Orbit {
    glm::vec3 target_m{0.0f};
    float distance_m = 1.0f;
    float yaw_rad = 0.0f;    ///< 0 looks along −Z, growing turns the camera to the left of what it looks at
    float pitch_rad = 0.0f;  ///< growing lifts the camera
};

/// Three-quarter view in which `box` just fits into the picture, whatever its scale.
/// @param box     may be a point or empty: then a box of two metres is framed
/// @param aspect  width / height of the picture
[[nodiscard]] Orbit frame_bounds(const assets::Bounds& box, float vertical_fov_rad, float aspect);

/// Eye of an orbit, with a near plane that suits the distance.
/// @param origin  where the scene's own (0,0,0) stands
/// @param like    what all else is taken from: kind, field of view
[[nodiscard]] systems::Eye eye_of(const Orbit& orbit, const systems::WorldPosition& origin,
                                  const systems::Eye& like = {});

/// The orbit that `eye` is on around what it sees of a box: eye_of() it looks the same way from the same
/// place, but for a roll, which orbits do not have.
[[nodiscard]] Orbit orbit_of(const systems::Eye& eye, const assets::Bounds& box,
                             const systems::WorldPosition& origin);

/// Light for a viewed scene, apart from its lamps: that of a time of day, if one is wished for, with no sun
/// but its own. Else its first directional light is the sun, under the sky of the scene's own time; where it
/// knows none, the sky is kept soft if it has lights, so that shadows are not black and the file's light
/// dominates, and is noon's if it has none.
struct ViewingLight {
    assets::Environment environment;
    float exposure_ev = 0.0f;
};
[[nodiscard]] ViewingLight viewing_light(const assets::Scene& scene, std::optional<assets::TimeOfDay> time);

/// Takes away all directional lights, which a time of day's own sun replaces.
void remove_suns(assets::Scene& scene);

}  // namespace rambla::game
