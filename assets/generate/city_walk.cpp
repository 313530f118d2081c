#include "assets/generate/city_walk.h"

#include <array>

namespace rambla::assets::generate {

namespace {

/// A key relative to the street's middle and the walked row's: x to the right, ahead along −z.
struct Step {
    float time_s;
    float right_m, ahead_m;
    glm::vec3 look;  ///< right, up (above the road), ahead of the eye
};

constexpr float k_eye_m = 1.65f;
// The lane is left of the street's middle; this side is free of parked cars along the walk.
constexpr std::array<Step, 10> k_steps{{{0.0f, 1.35f, 0.8f, {-1.6f, 2.30f, 18.0f}},
                                        {2.0f, 1.35f, 2.2f, {-1.8f, 2.35f, 18.0f}},
                                        {4.0f, 1.35f, 4.4f, {-5.5f, 3.20f, 12.0f}},
                                        {6.0f, 1.30f, 7.0f, {-6.5f, 4.60f, 8.0f}},
                                        {8.0f, 1.25f, 9.8f, {-1.0f, 3.00f, 14.0f}},
                                        {10.0f, 1.20f, 13.0f, {4.2f, 2.10f, 9.0f}},
                                        {12.0f, 1.10f, 17.2f, {2.0f, 2.20f, 14.0f}},
                                        {14.0f, 0.90f, 22.0f, {-3.5f, 3.40f, 12.0f}},
                                        {15.0f, 0.75f, 24.6f, {-7.0f, 4.20f, 11.0f}},
                                        {16.0f, 0.60f, 27.0f, {-8.5f, 4.40f, 10.0f}}}};
static_assert(k_steps.front().ahead_m == k_walk_from_m && k_steps.back().ahead_m == k_walk_to_m);

}  // namespace

std::vector<CameraKey> plan_walk(const CityPlan& plan) {
    const float street = plan.street_x(plan.walked_street());
    const float row = plan.block_centre(0, plan.walked_row()).y;
    std::vector<CameraKey> keys;
    for (const Step& step : k_steps) {
        const glm::vec3 eye{street + step.right_m, k_eye_m, row - step.ahead_m};
        keys.push_back({step.time_s, eye, {eye.x + step.look.x, step.look.y, eye.z - step.look.z}});
    }
    return keys;
}

}  // namespace rambla::assets::generate
