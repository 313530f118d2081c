#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "assets/trace/picture.h"
#include "game/study/result.h"
#include "render/render_thread.h"

namespace rambla::game::study {

/// How far places and normals that lighting reads of the G-buffer are from what the ray through each pixel's
/// middle meets. Pixels at the rim of an object or at a step in depth are left out: there, ray and rasteriser
/// may rightly meet two surfaces. Pixels that show another surface, or nothing that is finite, are counted
/// and left out as well.
class SurfaceErrors {
public:
    /// @param seen  traced by the camera that the others are drawn by
    void add(const assets::HitPicture& seen, const render::ObjectImage& objects,
             const render::SurfaceImages& surfaces);

    /// Of all pixels that are compared, nothing without one: `position_p50_mm`, `position_p99_mm`,
    /// `position_max_mm`, `position_p99_ppm` of the distance from the eye, `angle_p50_deg`, `angle_p99_deg`,
    /// `angle_max_deg`. Always, of all pixels: `other_surface_pct`, which are farther off than a hundredth of
    /// the distance, and so show another surface (masks, coincident faces); `broken_pct`, which have no
    /// finite place or no normal; `compared_pct`.
    [[nodiscard]] std::vector<Metric> metrics() const;

private:
    std::vector<double> position_mm_;
    std::vector<double> position_ppm_;
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec3> normals_found_;
    std::size_t pixels_ = 0;
    std::size_t broken_ = 0;
    std::size_t other_surfaces_ = 0;
};

}  // namespace rambla::game::study
