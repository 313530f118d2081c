#include "game/view_session.h"

#include <algorithm>
#include <cmath>

namespace rambla::game {
namespace {

constexpr float k_orbit_rad_per_px = 0.006f;
constexpr float k_highest_pitch_rad = 1.55f;  // just short of the pole
constexpr float k_wheel_factor = 0.88f;       // each notch comes an eighth nearer

}  // namespace

ViewSession::ViewSession(Stage& stage, const systems::Eye& start, const assets::Bounds& box)
    : origin_{stage.origin}, eye_{start}, orbit_{orbit_of(start, box, stage.origin)}, clips_{stage} {}

Shot ViewSession::update(const Moment& moment) {
    const Input& input = moment.input;
    if (moment.pointer_free && input.button_held() && input.pointer_way() != glm::vec2{0.0f}) {
        orbit_.yaw_rad -= k_orbit_rad_per_px * input.pointer_way().x;
        orbit_.pitch_rad = std::clamp(orbit_.pitch_rad + k_orbit_rad_per_px * input.pointer_way().y,
                                      -k_highest_pitch_rad, k_highest_pitch_rad);
        eye_ = eye_of(orbit_, origin_, eye_);
    }
    if (moment.pointer_free && input.wheel() != 0.0f) {
        const float nearer = std::pow(k_wheel_factor, input.wheel());
        orbit_.distance_m *= nearer;
        eye_.half_height_m *= nearer;  // an orthographic picture does not grow by coming nearer
        eye_ = eye_of(orbit_, origin_, eye_);
    }
    const float interpolation = clips_.update(moment);
    return {
        .eye = eye_, .interpolation = interpolation, .steps = clips_.steps(), .caption = clips_.caption()};
}

}  // namespace rambla::game
