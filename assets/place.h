#pragma once

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

enum class ActorKind : std::uint8_t { walker, car };

/// An actor that the place starts with.
struct ActorStart {
    ActorKind kind = ActorKind::walker;
    std::uint32_t prototype = k_none;  ///< node of the scene whose subtree is spawned
    std::uint32_t link = 0;            ///< of the walkers' or cars' network
    float along = 0.0f;                ///< 0 at the link's start, 1 at its end
    float aside_m = 0.0f;              ///< signed offset to the right of the link's direction
    float speed_m_s = 1.3f;
    bool backwards = false;            ///< starts towards `from`
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
    PathNetwork pavements;
    PathNetwork lanes;
    std::vector<ActorStart> actors;
    std::vector<CameraKey> walk;   ///< times ascend from 0; interpolated smoothly
    float walk_fov_rad = 1.0f;     ///< vertical
};

}  // namespace rambla::assets
