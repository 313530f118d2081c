#include "assets/generate/vehicles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/generate/node.h"

namespace rambla::assets::generate {

namespace {

/// Half a cross-section of a car at z (−z is forwards): sill, waist and roof heights and half widths.
struct Station {
    float z, sill, waist, top;
    float half_waist, half_top;
    bool glass_after;   ///< between this station and the next, waist to top is window
    bool screen_after;  ///< between this station and the next, the top is a wind screen
};

std::vector<Station> stations(CarKind kind) {
    switch (kind) {
        case CarKind::hatchback:
            return {{-1.98f, 0.34f, 0.58f, 0.60f, 0.70f, 0.62f, false, false},
                    {-1.88f, 0.24f, 0.68f, 0.72f, 0.82f, 0.72f, false, false},
                    {-1.30f, 0.22f, 0.80f, 0.88f, 0.86f, 0.74f, false, false},
                    {-0.92f, 0.22f, 0.86f, 0.95f, 0.87f, 0.74f, true, true},
                    {-0.25f, 0.22f, 0.89f, 1.42f, 0.87f, 0.60f, true, false},
                    {0.55f, 0.22f, 0.92f, 1.46f, 0.87f, 0.61f, true, false},
                    {1.30f, 0.22f, 0.95f, 1.40f, 0.86f, 0.59f, false, true},
                    {1.84f, 0.26f, 0.94f, 1.00f, 0.82f, 0.68f, false, false},
                    {1.98f, 0.36f, 0.80f, 0.82f, 0.74f, 0.64f, false, false}};
        case CarKind::saloon:
            return {{-2.22f, 0.34f, 0.58f, 0.60f, 0.72f, 0.64f, false, false},
                    {-2.10f, 0.24f, 0.68f, 0.73f, 0.84f, 0.74f, false, false},
                    {-1.40f, 0.22f, 0.78f, 0.87f, 0.88f, 0.76f, false, false},
                    {-0.86f, 0.22f, 0.84f, 0.94f, 0.89f, 0.76f, true, true},
                    {-0.10f, 0.22f, 0.87f, 1.38f, 0.89f, 0.60f, true, false},
                    {0.62f, 0.22f, 0.89f, 1.40f, 0.89f, 0.60f, true, false},
                    {1.10f, 0.22f, 0.91f, 1.32f, 0.88f, 0.57f, false, true},
                    {1.62f, 0.22f, 0.92f, 0.98f, 0.87f, 0.74f, false, false},
                    {2.12f, 0.26f, 0.88f, 0.94f, 0.83f, 0.72f, false, false},
                    {2.24f, 0.36f, 0.74f, 0.76f, 0.76f, 0.66f, false, false}};
        case CarKind::van:
            break;
    }
    return {{-2.20f, 0.34f, 0.66f, 0.68f, 0.76f, 0.68f, false, false},
            {-2.10f, 0.26f, 0.84f, 0.90f, 0.86f, 0.78f, false, false},
            {-1.70f, 0.24f, 1.00f, 1.08f, 0.90f, 0.80f, true, true},
            {-1.05f, 0.24f, 1.05f, 1.78f, 0.91f, 0.74f, true, false},
            {-0.20f, 0.24f, 1.06f, 1.86f, 0.91f, 0.75f, false, false},
            {1.20f, 0.24f, 1.06f, 1.87f, 0.91f, 0.75f, false, false},
            {2.12f, 0.24f, 1.06f, 1.84f, 0.90f, 0.74f, false, false},
            {2.20f, 0.32f, 1.00f, 1.78f, 0.86f, 0.71f, false, false}};
}

/// Points of a whole cross-section from the right sill over the roof to the left one.
constexpr std::size_t k_half_points = 7;
constexpr std::size_t k_section_points = 2 * k_half_points;

std::array<glm::vec3, k_section_points> section(const Station& s) {
    const float top_bevel = std::min(0.07f, 0.45f * (s.top - s.waist));
    const std::array<glm::vec2, k_half_points> half{{{s.half_waist - 0.10f, s.sill},
                                                     {s.half_waist - 0.015f, s.sill + 0.09f},
                                                     {s.half_waist, s.sill + 0.55f * (s.waist - s.sill)},
                                                     {s.half_waist - 0.025f, s.waist},
                                                     {s.half_top + 0.03f, s.top - top_bevel},
                                                     {s.half_top - 0.06f, s.top - 0.012f},
                                                     {0.5f * s.half_top, s.top + 0.012f}}};
    std::array<glm::vec3, k_section_points> result;
    for (std::size_t i = 0; i < k_half_points; ++i) {
        result[i] = {half[i].x, half[i].y, s.z};
        result[k_section_points - 1 - i] = {-half[i].x, half[i].y, s.z};
    }
    return result;
}

void build_shell(Builder& b, const std::vector<Station>& profile) {
    std::vector<glm::vec3> points;
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const auto ring = section(profile[i]);
        points.insert(points.end(), ring.begin(), ring.end());
        if (i + 1 == profile.size()) break;
        for (std::size_t k = 0; k + 1 < k_section_points; ++k) {
            const bool side_window = profile[i].glass_after && (k == 3 || k == k_section_points - 5);
            const bool screen = profile[i].screen_after && k >= 4 && k + 5 < k_section_points;
            surfaces.push_back(side_window || screen ? Surface::car_glass : Surface::body);
        }
    }
    constexpr float k_crease_rad = 0.75f;
    b.sheet(points, k_section_points, surfaces, k_crease_rad);
    for (const bool front : {true, false}) {
        const auto ring = section(front ? profile.front() : profile.back());
        for (std::size_t k = 0; k + 1 < k_half_points; ++k) {
            const glm::vec3 right = ring[k];
            const glm::vec3 right_up = ring[k + 1];
            const glm::vec3 left = ring[k_section_points - 1 - k];
            const glm::vec3 left_up = ring[k_section_points - 2 - k];
            if (front)
                b.face(Surface::body, right, left, left_up, right_up);
            else
                b.face(Surface::body, left, right, right_up, left_up);
        }
    }
    // The floor, seen only by shadows and reflections.
    const Station& first = profile.front();
    const Station& last = profile.back();
    const float half = first.half_waist - 0.10f;
    b.face(Surface::rubber, {-half, first.sill, first.z}, {half, first.sill, first.z},
           {half, last.sill, last.z}, {-half, last.sill, last.z});
}

/// Dark half disc of a wheel arch on the body's side.
void build_arch(Builder& b, float x, float z, float radius, bool right) {
    constexpr int k_steps = 8;
    std::vector<glm::vec3> corners;
    for (int i = 0; i <= k_steps; ++i) {
        const float angle = 3.14159265f * static_cast<float>(i) / static_cast<float>(k_steps);
        corners.push_back(
            {x, 0.30f + radius * std::sin(angle), z - radius * std::cos(angle) * (right ? -1.0f : 1.0f)});
    }
    std::reverse(corners.begin(), corners.end());
    b.polygon(Surface::rubber, corners);
}

}  // namespace

CarSize car_size(CarKind kind) {
    switch (kind) {
        case CarKind::hatchback:
            return {3.96f, 1.74f, 0.31f, 1.22f, 1.24f};
        case CarKind::saloon:
            return {4.46f, 1.78f, 0.32f, 1.36f, 1.34f};
        case CarKind::van:
            break;
    }
    return {4.40f, 1.82f, 0.33f, 1.42f, 1.38f};
}

void build_car_body(Builder& b, CarKind kind) {
    const std::vector<Station> profile = stations(kind);
    build_shell(b, profile);
    const CarSize size = car_size(kind);
    const float side = 0.5f * size.width_m + 0.02f;
    for (const float z : {-size.front_axle_m, size.rear_axle_m}) {
        build_arch(b, side, z, size.wheel_radius_m + 0.07f, true);
        build_arch(b, -side, z, size.wheel_radius_m + 0.07f, false);
    }
    const float nose = profile.front().z;
    const float tail = profile.back().z;
    for (const float sign : {-1.0f, 1.0f}) {
        const float x = sign * 0.56f;
        b.box(Surface::head_lamp, {x - 0.14f, 0.56f, nose - 0.02f}, {x + 0.14f, 0.68f, nose + 0.22f});
        const float lamp = kind == CarKind::van ? 1.02f : 0.74f;
        b.box(Surface::tail_lamp, {sign * 0.66f - 0.08f, lamp, tail - 0.22f},
              {sign * 0.66f + 0.08f, lamp + 0.16f, tail + 0.015f});
        const float waist = profile[3].waist;
        b.box(Surface::body, {std::min(sign * 0.86f, sign * 1.02f), waist, profile[3].z + 0.12f},
              {std::max(sign * 0.86f, sign * 1.02f), waist + 0.13f, profile[3].z + 0.22f});
    }
    b.box(Surface::rubber, {-0.66f, 0.30f, nose - 0.03f}, {0.66f, 0.44f, nose + 0.2f});
    b.box(Surface::rubber, {-0.70f, 0.32f, tail - 0.2f}, {0.70f, 0.46f, tail + 0.03f});
    b.box(Surface::metal, {-0.24f, 0.34f, nose - 0.045f}, {0.24f, 0.43f, nose});
    b.box(Surface::metal, {-0.24f, 0.36f, tail}, {0.24f, 0.45f, tail + 0.045f});
}

void build_wheel(Builder& b, const CarSize& size, float side) {
    const float r = size.wheel_radius_m;
    const auto ring = [&](float x, float radius) {
        return Ring{{side * x, 0.0f, 0.0f}, {0.0f, radius, 0.0f}, {0.0f, 0.0f, radius}};
    };
    const std::array<Ring, 4> tyre{ring(-0.09f, 0.90f * r), ring(-0.07f, r), ring(0.07f, r),
                                   ring(0.095f, 0.72f * r)};
    b.tube(Surface::rubber, tyre, 14, true, false);
    const std::array<Ring, 3> rim{ring(0.095f, 0.72f * r), ring(0.075f, 0.62f * r), ring(0.10f, 0.16f * r)};
    b.tube(Surface::metal, rim, 14, false, true);
}

std::uint32_t add_car(Scene& scene, const CarMeshes& meshes, CarKind kind, const Scheme& scheme) {
    const CarSize size = car_size(kind);
    const std::uint32_t car = add_node(scene, "car", k_none, {});
    scene.nodes[car].model = add_model(scene, "car", meshes.body, scheme);
    const std::uint32_t left = add_model(scene, "wheel-left", meshes.left_wheel, scheme);
    const std::uint32_t right = add_model(scene, "wheel-right", meshes.right_wheel, scheme);
    const float x = 0.5f * size.width_m - 0.06f;
    const auto add_wheel = [&](const char* name, float side, float z) {
        Transform local;
        local.translation_m = {side * x, size.wheel_radius_m, z};
        scene.nodes[add_node(scene, name, car, local)].model = side < 0.0f ? left : right;
    };
    add_wheel("wheel_fl", -1.0f, -size.front_axle_m);
    add_wheel("wheel_fr", 1.0f, -size.front_axle_m);
    add_wheel("wheel_rl", -1.0f, size.rear_axle_m);
    add_wheel("wheel_rr", 1.0f, size.rear_axle_m);
    return car;
}

}  // namespace rambla::assets::generate
