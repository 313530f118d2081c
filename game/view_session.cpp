#include "game/view_session.h"

#include <algorithm>
#include <cmath>

#include "game/clip_panel.h"
#include "game/scene_camera.h"

namespace rambla::game {
namespace {

constexpr float k_orbit_rad_per_px = 0.006f;
constexpr float k_highest_pitch_rad = 1.55f;  // just short of the pole
constexpr float k_wheel_factor = 0.88f;       // each notch comes an eighth nearer

}  // namespace

ViewSession::ViewSession(ModelView& view) : view_{view}, clips_{view.stage} {}

Shot ViewSession::update(const Moment& moment) {
    const float interpolation = clips_.update(moment);
    if (view_.camera && !orbit_) view_.eye = camera_eye(view_.stage, *view_.camera, interpolation);
    if (moment.pointer_free) follow_mouse(moment.input);
    return {.eye = view_.eye,
            .interpolation = interpolation,
            .steps = clips_.steps(),
            .caption = clips_.caption()};
}

void ViewSession::draw_overlay_part() {
    draw_clip_panel(clips_);
}

void ViewSession::follow_mouse(const Input& input) {
    const glm::vec2 way = input.button_held() ? input.pointer_way() : glm::vec2{0.0f};
    if (way == glm::vec2{0.0f} && input.wheel() == 0.0f) return;
    const systems::WorldPosition& origin = view_.stage.origin;
    if (!orbit_) orbit_ = orbit_of(view_.eye, view_.box, origin);
    orbit_->yaw_rad -= k_orbit_rad_per_px * way.x;
    orbit_->pitch_rad =
        std::clamp(orbit_->pitch_rad + k_orbit_rad_per_px * way.y, -k_highest_pitch_rad, k_highest_pitch_rad);
    const float nearer = std::pow(k_wheel_factor, input.wheel());
    orbit_->distance_m *= nearer;
    view_.eye.half_height_m *= nearer;  // an orthographic picture does not grow by coming nearer
    view_.eye = eye_of(*orbit_, origin, view_.eye);
}

}  // namespace rambla::game
