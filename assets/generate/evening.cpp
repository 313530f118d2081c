#include "assets/generate/evening.h"

#include <array>
#include <cmath>

namespace rambla::assets::generate {

namespace {

/// By day as many windows and shop lamps burn as make a street look lived in.
constexpr Evening k_day{.lamps = 0.0f,
                        .warm_windows = 1.0f / 7.0f,
                        .blue_windows = 0.0f,
                        .bright_shops = 1.0f,
                        .lamps_at_shops = 0.33f};

/// What burns in the dark, by the clock.
struct Hour {
    float hour;
    float warm_windows, blue_windows, bright_shops, lamps_at_shops;
};
/// People come home, watch, go to bed, and some get up early; shops close one after the other.
constexpr std::array<Hour, 10> k_hours{{{0.0f, 0.14f, 0.035f, 0.30f, 0.35f},
                                        {1.0f, 0.08f, 0.020f, 0.20f, 0.25f},
                                        {2.0f, 0.04f, 0.008f, 0.15f, 0.20f},
                                        {4.0f, 0.03f, 0.004f, 0.15f, 0.20f},
                                        {5.0f, 0.07f, 0.004f, 0.20f, 0.25f},
                                        {7.0f, 0.15f, 0.010f, 0.60f, 0.40f},
                                        {17.0f, 0.18f, 0.020f, 1.00f, 0.70f},
                                        {20.0f, 0.26f, 0.045f, 0.95f, 0.80f},
                                        {22.0f, 0.27f, 0.060f, 0.60f, 0.70f},
                                        {24.0f, 0.14f, 0.035f, 0.30f, 0.35f}}};

Evening dark_at(float hour) {
    std::size_t next = 1;
    while (next + 1 < k_hours.size() && k_hours[next].hour < hour)
        ++next;
    const Hour& a = k_hours[next - 1];
    const Hour& b = k_hours[next];
    const float share = (hour - a.hour) / (b.hour - a.hour);
    return {.lamps = 1.0f,
            .warm_windows = std::lerp(a.warm_windows, b.warm_windows, share),
            .blue_windows = std::lerp(a.blue_windows, b.blue_windows, share),
            .bright_shops = std::lerp(a.bright_shops, b.bright_shops, share),
            .lamps_at_shops = std::lerp(a.lamps_at_shops, b.lamps_at_shops, share)};
}

}  // namespace

Evening evening_at(TimeOfDay time) {
    if (!time.solar_minutes) return k_day;
    constexpr float k_off_sine = 0.0697565f;  // sin 4°
    constexpr float k_full_sine = -0.0348995f;
    const float fallen =
        std::clamp((k_off_sine - sun_height_sine(time)) / (k_off_sine - k_full_sine), 0.0f, 1.0f);
    const float share = fallen * fallen * (3.0f - 2.0f * fallen);
    const Evening dark = dark_at(static_cast<float>(*time.solar_minutes) / 60.0f);
    return {.lamps = share,
            .warm_windows = std::lerp(k_day.warm_windows, dark.warm_windows, share),
            .blue_windows = std::lerp(k_day.blue_windows, dark.blue_windows, share),
            .bright_shops = std::lerp(k_day.bright_shops, dark.bright_shops, share),
            .lamps_at_shops = std::lerp(k_day.lamps_at_shops, dark.lamps_at_shops, share)};
}

std::uint32_t add_lamp(Scene& scene, const char* name, LightKind kind, glm::vec3 colour, float intensity,
                       float range_m) {
    Light light;
    light.name = name;
    light.kind = kind;
    light.colour = colour;
    light.intensity = intensity;
    light.range_m = range_m;
    light.inner_cone_rad = 0.5f;
    light.outer_cone_rad = 1.0f;
    scene.lights.push_back(light);
    return static_cast<std::uint32_t>(scene.lights.size() - 1);
}

}  // namespace rambla::assets::generate
