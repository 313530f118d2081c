#include "render/post/adaptation.h"

#include <algorithm>
#include <cmath>

namespace rambla::render {
namespace {

/// By expm1, which keeps the digits of shares that are small.
double followed_share(double dt_s, double tau_s) {
    if (!(dt_s > 0.0)) return 0.0;  // NaN as well
    return tau_s > 0.0 ? -std::expm1(-dt_s / tau_s) : 1.0;
}

}  // namespace

FollowedShares followed_shares(double dt_s, const ExposureParameters& parameters) {
    return {.up = followed_share(dt_s, static_cast<double>(parameters.up_s)),
            .down = followed_share(dt_s, static_cast<double>(parameters.down_s))};
}

double target_ev(double average_luminance, const ExposureParameters& parameters) {
    const auto range_ev = static_cast<double>(parameters.range_ev);
    const double stops = std::log2(average_luminance / static_cast<double>(parameters.key));
    return std::clamp(-static_cast<double>(parameters.strength) * stops, -range_ev, range_ev);
}

double followed_ev(double ev, double target, const FollowedShares& shares) {
    const double share = target > ev ? shares.up : shares.down;
    return share < 1.0 ? ev + (target - ev) * share : target;
}

}  // namespace rambla::render
