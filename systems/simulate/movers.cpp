#include "systems/simulate/movers.h"

#include <algorithm>
#include <cmath>

#include "systems/pipeline.h"
#include "systems/simulate/trigonometry.h"

namespace rambla::systems {

Course advanced(Course course, float speed_m_s, float reach_m, float step_s) {
    const auto heading = static_cast<double>(course.heading_rad);
    course.x_m += static_cast<float>(cosine(heading)) * speed_m_s * step_s;
    course.z_m += static_cast<float>(sine(heading)) * speed_m_s * step_s;
    if (std::fabs(course.x_m) > reach_m) {
        course.heading_rad = static_cast<float>(k_pi) - course.heading_rad;
        course.x_m = std::clamp(course.x_m, -reach_m, reach_m);
    }
    if (std::fabs(course.z_m) > reach_m) {
        course.heading_rad = -course.heading_rad;
        course.z_m = std::clamp(course.z_m, -reach_m, reach_m);
    }
    return course;
}

glm::quat heading_rotation(float heading_rad) {
    // About +Y, right-handed angles run from +Z towards +X: the other way round.
    const double half = -0.5 * static_cast<double>(heading_rad);
    return {static_cast<float>(cosine(half)), 0.0f, static_cast<float>(sine(half)), 0.0f};
}

void advance_movers(ecs::View<Mover, LocalTransform> movers) {
    movers.for_each_chunk([](const auto& chunk) {
        constexpr auto k_step = static_cast<float>(k_step_s);
        chunk.each([](Mover& mover, LocalTransform& local) {
            const Course course = advanced({local.translation_m.x, local.translation_m.z, mover.heading_rad},
                                           mover.speed_m_s, mover.reach_m, k_step);
            local.translation_m.x = course.x_m;
            local.translation_m.z = course.z_m;
            mover.heading_rad = course.heading_rad;
            local.rotation = heading_rotation(course.heading_rad);
        });
    });
}

}  // namespace rambla::systems
