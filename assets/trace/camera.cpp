#include "assets/trace/camera.h"

#include <limits>

namespace rambla::assets {
namespace {

/// Depth of view space at which a clip matrix has the given depth: of (P22·z + P32)/(−z), or of P22·z + P32.
double view_depth(const glm::dmat4& clip_from_view, bool orthographic, double depth) {
    const double a = clip_from_view[2][2];
    const double b = clip_from_view[3][2];
    const double z = orthographic ? (depth - b) / a : -b / (a + depth);
    return a + (orthographic ? 0.0 : depth) == 0.0 ? std::numeric_limits<double>::infinity() : -z;
}

}  // namespace

CameraRays::CameraRays(const TraceCamera& camera)
    : world_from_view_{glm::inverse(glm::dmat4{camera.view_from_world})},
      clip_from_view_{camera.clip_from_view},
      size_px_{camera.size_px},
      orthographic_{camera.orthographic},
      near_m_{view_depth(clip_from_view_, orthographic_, 1.0)},
      far_m_{view_depth(clip_from_view_, orthographic_, 0.0)} {
    const TraceRay here = through({0.5, 0.5});
    const TraceRay right = through({1.5, 0.5});
    const TraceRay below = through({0.5, 1.5});
    spread_ = {.origin_right_m = right.origin_m - here.origin_m,
               .origin_below_m = below.origin_m - here.origin_m,
               .direction_right = right.direction - here.direction,
               .direction_below = below.direction - here.direction};
}

glm::dvec2 CameraRays::clip_place(glm::dvec2 place_px) const {
    const glm::dvec2 share = place_px / glm::dvec2{size_px_};
    return {2.0 * share.x - 1.0, 1.0 - 2.0 * share.y};
}

// Perspective: clip.xy/clip.w = (P00·x + P20·z)/(−z), so that at z = −1 x = (ndc + P20)/P00. Orthographic:
// x = (ndc − P30)/P00. Likewise y.
TraceRay CameraRays::through(glm::dvec2 place_px) const {
    const glm::dvec2 place = clip_place(place_px);
    const glm::dvec2 scale{clip_from_view_[0][0], clip_from_view_[1][1]};
    const glm::dvec2 shift{clip_from_view_[orthographic_ ? 3 : 2]};
    const glm::dvec2 aside = (orthographic_ ? place - shift : place + shift) / scale;
    const glm::dvec4 origin{orthographic_ ? aside : glm::dvec2{0.0}, 0.0, 1.0};
    const glm::dvec4 direction{orthographic_ ? glm::dvec2{0.0} : aside, -1.0, 0.0};
    return {.origin_m = glm::dvec3{world_from_view_ * origin},
            .direction = glm::dvec3{world_from_view_ * direction},
            .t_min = near_m_,
            .t_max = far_m_,
            .faces = TraceFaces::seen,
            .rays = k_rays_of_sight};
}

TraceRay CameraRays::through_pixel(std::uint32_t x, std::uint32_t y) const {
    return through({static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5});
}

}  // namespace rambla::assets
