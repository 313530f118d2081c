#include "game/camera_path.h"

#include <algorithm>
#include <cmath>

#include "assets/assert.h"

namespace rambla::game {
namespace {

using Keys = std::span<const assets::CameraKey>;
using Track = glm::vec3 assets::CameraKey::*;

glm::vec3 slope(Keys keys, Track track, std::size_t i) {
    const float step_s = keys[i + 1].time_s - keys[i].time_s;
    return step_s > 0.0f ? (keys[i + 1].*track - keys[i].*track) / step_s : glm::vec3{0.0f};
}

/// Derivative at key i of the parabola through keys i−1, i, i+1; at the ends, the slope of the only
/// neighbour.
glm::vec3 tangent(Keys keys, Track track, std::size_t i) {
    if (i == 0) return slope(keys, track, 0);
    if (i + 1 == keys.size()) return slope(keys, track, i - 1);
    const float before_s = keys[i].time_s - keys[i - 1].time_s;
    const float after_s = keys[i + 1].time_s - keys[i].time_s;
    const float whole_s = before_s + after_s;
    if (whole_s <= 0.0f) return glm::vec3{0.0f};
    return (slope(keys, track, i - 1) * after_s + slope(keys, track, i) * before_s) / whole_s;
}

glm::vec3 hermite(Keys keys, Track track, std::size_t i, float share) {
    const float step_s = keys[i + 1].time_s - keys[i].time_s;
    const float s2 = share * share;
    const float s3 = s2 * share;
    return (2.0f * s3 - 3.0f * s2 + 1.0f) * keys[i].*track +
           (s3 - 2.0f * s2 + share) * step_s * tangent(keys, track, i) +
           (3.0f * s2 - 2.0f * s3) * keys[i + 1].*track + (s3 - s2) * step_s * tangent(keys, track, i + 1);
}

}  // namespace

float duration_s(Keys keys) {
    return keys.empty() ? 0.0f : keys.back().time_s;
}

CameraPose pose_at(Keys keys, float time_s) {
    RAMBLA_ASSERT(!keys.empty(), "a path has keys");
    if (time_s <= keys.front().time_s) return {keys.front().eye_m, keys.front().target_m};
    if (time_s >= keys.back().time_s) return {keys.back().eye_m, keys.back().target_m};
    const auto after = std::upper_bound(keys.begin(), keys.end(), time_s,
                                        [](float t, const assets::CameraKey& key) { return t < key.time_s; });
    const std::size_t i = static_cast<std::size_t>(after - keys.begin()) - 1;
    const float share = (time_s - keys[i].time_s) / (keys[i + 1].time_s - keys[i].time_s);
    return {hermite(keys, &assets::CameraKey::eye_m, i, share),
            hermite(keys, &assets::CameraKey::target_m, i, share)};
}

glm::quat look_rotation(glm::vec3 eye, glm::vec3 target) {
    const glm::vec3 ahead = target - eye;
    const float distance = glm::length(ahead);
    if (!(distance > 0.0f)) return {1.0f, 0.0f, 0.0f, 0.0f};
    const glm::vec3 back = -ahead / distance;
    glm::vec3 right = glm::cross(glm::vec3{0.0f, 1.0f, 0.0f}, back);
    if (glm::length(right) < 1e-6f)
        right = {1.0f, 0.0f, 0.0f};  // straight up or down: any horizontal axis will do
    right = glm::normalize(right);
    return glm::normalize(glm::quat_cast(glm::mat3{right, glm::cross(back, right), back}));
}

}  // namespace rambla::game
