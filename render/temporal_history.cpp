#include "render/temporal_history.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/jitter.h"

namespace rambla::render {
namespace {

/// Edge of a FrameView's cell.
constexpr double k_cell_m = 256.0;

/// Cells are subtracted as integers: exact wherever in the world both eyes are.
glm::dvec3 eye_shift_m(const systems::FrameView& then, const systems::FrameView& now) {
    const glm::i64vec3 cells = glm::i64vec3{now.eye_cell} - glm::i64vec3{then.eye_cell};
    return glm::dvec3{cells} * k_cell_m + (glm::dvec3{now.eye_local_m} - glm::dvec3{then.eye_local_m});
}

bool is_same_camera(const systems::FrameView& a, const systems::FrameView& b) {
    return a.view_from_world == b.view_from_world && a.clip_from_view == b.clip_from_view &&
           a.eye_cell == b.eye_cell && a.eye_local_m == b.eye_local_m;
}

glm::dmat4 clip_from_world(const systems::FrameView& view) {
    return glm::dmat4{view.clip_from_view} * glm::dmat4{view.view_from_world};
}

}  // namespace

bool is_temporal(const Settings& settings) {
    return settings.anti_aliasing.method == AntiAliasing::taa && settings.debug.view == DebugView::off;
}

shared::TemporalConstants make_temporal_constants(const TemporalFrame& frame,
                                                  const AntiAliasingParameters& parameters) {
    return {.past_from_present = frame.past_from_present,
            .past_clip_from_world = frame.past_clip_from_world,
            .jitter = {frame.jitter_px, 0.0f, 0.0f},
            .history = {1.0f - parameters.history, frame.exposure_ratio, frame.has_past ? 1.0f : 0.0f, 0.0f},
            .counts = {frame.moved->count(), 0, 0, 0}};
}

bool TemporalHistory::is_cut(const systems::Frame& frame) const {
    const systems::FrameView& then = past_->view;
    const systems::FrameView& now = frame.view;
    if (then.size_px != now.size_px || then.orthographic != now.orthographic) return true;
    const double passed_s = frame.time_s - past_->time_s;
    const double moved_m = glm::length(eye_shift_m(then, now));
    const auto ahead = [](const systems::FrameView& view) {
        return -glm::transpose(view.view_from_world)[2];
    };
    const float cosine = glm::dot(glm::vec3{ahead(then)}, glm::vec3{ahead(now)});
    // So that what is no number is a cut.
    const bool goes_on =
        passed_s >= 0.0 && passed_s <= k_cut_s && moved_m <= k_cut_m && cosine >= std::cos(k_cut_angle_rad);
    return !goes_on;
}

const TemporalFrame& TemporalHistory::follow(const systems::Frame& frame, float exposure, bool continues) {
    frame_ = {};
    frame_.has_past = continues && past_.has_value() && !is_cut(frame);
    if (!frame_.has_past) {
        things_.forget();
        pictures_ = 0;
        past_ = Past{frame.view, frame.time_s, exposure};
    }
    frame_.jitter_px = jitter_px(pictures_++);
    frame_.view = shifted(frame.view, frame_.jitter_px);
    frame_.camera_moved = !is_same_camera(past_->view, frame.view);
    const glm::dvec3 shift_m = eye_shift_m(past_->view, frame.view);
    const glm::dmat4 past_clip = clip_from_world(past_->view);
    frame_.past_clip_from_world = glm::mat4{past_clip};
    frame_.past_from_present = glm::mat4{past_clip * glm::translate(glm::dmat4{1.0}, shift_m) *
                                         glm::inverse(clip_from_world(frame_.view))};
    frame_.exposure_ratio = exposure / past_->exposure;
    frame_.moved = &things_.follow(frame, shift_m);
    past_ = Past{frame.view, frame.time_s, exposure};
    return frame_;
}

}  // namespace rambla::render
