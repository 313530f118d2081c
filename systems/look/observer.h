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

/// A share of the way from one map to another, mixed linearly: 1/60 s turns a swinging limb by a few degrees
/// at most, over which the chord and the arc differ by less than a thousandth.
/// @param share  0 and below: `from`, 1 and above: `to`
[[nodiscard]] inline Placement between(const Placement& from, const Placement& to, float share) {
    // The ends are exact to the sign of zero, so that one step's end is the next one's beginning bit for bit.
    if (share <= 0.0f) return from;
    if (share >= 1.0f) return to;
    return {from.linear * (1.0f - share) + to.linear * share,
            from.translation_m * (1.0f - share) + to.translation_m * share};
}

/// Where a moving thing is, between two steps.
[[nodiscard]] inline Placement placement(const WorldTransform& before, const WorldTransform& now,
                                         const Observer& observer) {
    return between(placement(before, observer), placement(now, observer), observer.interpolation);
}

}  // namespace rambla::systems
