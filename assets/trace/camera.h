#pragma once

#include <glm/glm.hpp>

#include "assets/trace/ray.h"

namespace rambla::assets {

/// A camera as the renderer has it: reversed Z, depth 1 at the near plane, 0 at infinity or at the far plane.
struct TraceCamera {
    glm::mat4 view_from_world{1.0f};  ///< rotation and translation; looks along −Z
    glm::mat4 clip_from_view{1.0f};
    glm::uvec2 size_px{0};
    bool orthographic = false;
};

/// The rays of a camera's pixels, computed in double.
class CameraRays {
public:
    explicit CameraRays(const TraceCamera& camera);

    [[nodiscard]] glm::uvec2 size_px() const { return size_px_; }
    /// The ray through a place of the picture, from the near plane to the far one. One unit of its direction
    /// is one metre of depth: t = −z in view space.
    /// @param place_px  from the upper left corner; pixel centres lie at ½
    [[nodiscard]] TraceRay through(glm::dvec2 place_px) const;
    [[nodiscard]] TraceRay through_pixel(std::uint32_t x, std::uint32_t y) const;
    [[nodiscard]] const RaySpread& spread() const { return spread_; }  ///< the same for all pixels

private:
    [[nodiscard]] glm::dvec2 clip_place(glm::dvec2 place_px) const;

    glm::dmat4 world_from_view_;
    glm::dmat4 clip_from_view_;
    glm::uvec2 size_px_;
    bool orthographic_;
    double near_m_;
    double far_m_;
    RaySpread spread_;
};

}  // namespace rambla::assets
