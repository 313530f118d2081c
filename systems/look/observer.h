#pragma once

#include <glm/glm.hpp>

#include "systems/components.h"
#include "systems/position.h"

namespace rambla::systems {

/// What makes world transforms relative to the camera.
struct Observer {
    WorldPosition eye;
    float interpolation = 1.0f;  ///< 0: the step before, 1: the newest
};

/// Camera-relative affine map from an entity's own space.
struct Placement {
    glm::mat3 linear{1.0f};
    glm::vec3 translation_m{0.0f};
};

/// Where a resting thing is. Cells are subtracted as integers, so that places far from the world's origin
/// look the same.
[[nodiscard]] inline Placement placement(const WorldTransform& now, const Observer& observer) {
    return {now.linear, offset_m(observer.eye, {now.cell, now.translation_m})};
}

/// Where a moving thing is, between two steps. The maps are mixed linearly: 1/60 s turns a swinging limb by a
/// few degrees at most, over which the chord and the arc differ by less than a thousandth.
[[nodiscard]] inline Placement placement(const WorldTransform& before, const WorldTransform& now,
                                         const Observer& observer) {
    const Placement from = placement(before, observer);
    const Placement to = placement(now, observer);
    const float t = observer.interpolation;
    // The ends are exact to the sign of zero, so that one step's end is the next one's beginning bit for bit.
    if (t <= 0.0f) return from;
    if (t >= 1.0f) return to;
    return {from.linear * (1.0f - t) + to.linear * t, from.translation_m * (1.0f - t) + to.translation_m * t};
}

}  // namespace rambla::systems
