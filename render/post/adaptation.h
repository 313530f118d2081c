#pragma once

#include "render/settings/exposure.h"

namespace rambla::render {

/// How exposure follows what is seen, as exposure.glsl does it on the GPU.

/// Shares of the way to the target that a frame goes.
struct FollowedShares {
    double up = 0.0;    ///< to a brighter picture
    double down = 0.0;  ///< to a darker one
};

/// 1 − exp(−dt/τ), which makes ev(t + dt) = target + (ev − target)·exp(−dt/τ), however the time is divided
/// into frames. Where no time passes, where the clock goes backwards, or where it tells none (NaN), nothing
/// is followed; where τ is 0, all of it at once.
[[nodiscard]] FollowedShares followed_shares(double dt_s, const ExposureParameters& parameters);

/// Where exposure goes, in EV. @param average_luminance  of exposed scene light, > 0
[[nodiscard]] double target_ev(double average_luminance, const ExposureParameters& parameters);

/// A frame's step from ev to the target.
[[nodiscard]] double followed_ev(double ev, double target, const FollowedShares& shares);

}  // namespace rambla::render
