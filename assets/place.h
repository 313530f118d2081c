#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "assets/environment.h"
#include "assets/scene.h"

namespace rambla::assets {

/// A network of ways that actors follow: pavements and crossings for walkers, lanes for cars.
struct PathNetwork {
    struct Link {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        float half_width_m = 0.0f;  ///< actors keep this far to either side of the line at most
        bool both_ways = true;
    };
    std::vector<glm::vec3> points;
    std::vector<Link> links;
};

/// Half the breadth of the broadest generated person, sleeves included.
inline constexpr float k_walker_half_m = 0.32f;

/// Offsets to the right of the direction of travel that walkers keep to.
struct WalkerBand {
    float nearest_m = 0.0f;
    float farthest_m = 0.0f;
};

/// Who keeps half a breadth to the right of the middle never touches oncoming people; a narrower link leaves
/// only its edge. On wide links people use the inner half, so that corners do not turn them on the spot.
[[nodiscard]] inline WalkerBand walker_band(float half_width_m) {
    constexpr float k_inner_m = 0.75f;
    return {std::min(k_walker_half_m, half_width_m),
            std::min(half_width_m, std::max(k_inner_m, 0.5f * half_width_m))};
}

enum class ActorKind : std::uint8_t { walker, car };

/// An actor that the place starts with.
struct ActorStart {
    ActorKind kind = ActorKind::walker;
    std::uint32_t prototype = k_none;  ///< node of the scene whose subtree is spawned
    std::uint32_t link = 0;            ///< of the walkers' or cars' network
    float along = 0.0f;                ///< 0 at the link's start, 1 at its end
    float aside_m = 0.0f;              ///< signed offset to the right of the link's direction
    float speed_m_s = 1.3f;
    bool backwards = false;  ///< starts towards `from`
};

/// A node that goes straight ahead in its parent's xz plane and is mirrored by the walls of a square.
struct MoverStart {
    std::uint32_t node = k_none;  ///< shown by the scene; its translation is where it starts
    float heading_rad = 0.0f;     ///< from +X towards +Z; the node's own +X looks there
    float speed_m_s = 1.0f;
};

/// One key of a scripted camera path.
struct CameraKey {
    float time_s = 0.0f;
    glm::vec3 eye_m{0.0f};
    glm::vec3 target_m{0.0f};
};

/// A generated place: what is drawn, its light, who moves there, and the standard walk through it.
struct Place {
    Scene scene;
    Environment environment;
    float exposure_ev =
        0.0f;  ///< at which pictures of it look as its light should, unless the user knows better
    PathNetwork pavements;
    PathNetwork lanes;
    std::vector<ActorStart> actors;
    std::vector<MoverStart> movers;
    float mover_reach_m = 0.0f;   ///< the movers' walls stand at ±this in x and z
    std::vector<CameraKey> walk;  ///< times ascend from 0; interpolated smoothly
    float walk_fov_rad = 1.0f;    ///< vertical
    float walk_near_m = 0.05f;    ///< distance of the near plane
};

}  // namespace rambla::assets
