#include "assets/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

namespace rambla::assets {

namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_latitude_rad = 41.4 * k_pi / 180.0;
/// Of 5 June, the 156th day, by the series of Spencer 1971, "Fourier series representation of the position of
/// the sun".
constexpr double k_declination_rad = 22.5 * k_pi / 180.0;

/// Horizontal coordinates from hour angle H, declination δ and latitude φ: up = sin φ sin δ + cos φ cos δ cos
/// H, east = −cos δ sin H, north = cos φ sin δ − sin φ cos δ cos H (Meeus, "Astronomical algorithms", ch.
/// 13). The squares add up to 1 for any H.
glm::dvec3 to_sun(int solar_minutes) {
    const double hour_angle = (static_cast<double>(solar_minutes) / 720.0 - 1.0) * k_pi;
    const double along = std::cos(k_declination_rad) * std::cos(hour_angle);
    const double up =
        std::sin(k_latitude_rad) * std::sin(k_declination_rad) + std::cos(k_latitude_rad) * along;
    const double east = -std::cos(k_declination_rad) * std::sin(hour_angle);
    const double north =
        std::cos(k_latitude_rad) * std::sin(k_declination_rad) - std::sin(k_latitude_rad) * along;
    return {east, up, -north};
}

double degrees(double radians) {
    return radians * 180.0 / k_pi;
}

/// What the sun's light passes, in units of the air straight overhead. Kasten and Young 1989, "Revised
/// optical air mass tables and approximation formula". @param height_deg  > −6
double air_mass(double height_deg) {
    return 1.0 / (std::sin(height_deg * k_pi / 180.0) + 0.50572 * std::pow(height_deg + 6.07995, -1.6364));
}

/// Optical depths of one air mass for red, green and blue: molecules (0.06, 0.10, 0.20) and the haze of a
/// town.
constexpr glm::dvec3 k_optical_depth{0.15, 0.20, 0.31};
/// Centre of the disc when its upper edge disappears, with 34' of refraction: the usual definition of sunset.
constexpr double k_set_deg = -0.833;
/// Centre of the disc when its lower edge touches the horizon.
constexpr double k_touches_deg = k_set_deg + 2.0 * 0.2665;

/// Falls off with the air mass from what noon() has at its own height, and with the disc's part above the
/// horizon.
glm::vec3 sun_illuminance(double height_deg) {
    if (height_deg <= k_set_deg) return glm::vec3{0.0f};
    const Environment bright = noon();
    const double noon_deg = degrees(std::asin(static_cast<double>(bright.direction_to_sun.y)));
    const double share = std::clamp((height_deg - k_set_deg) / (k_touches_deg - k_set_deg), 0.0, 1.0);
    const double shown = share * share * (3.0 - 2.0 * share);
    const double more_air = air_mass(height_deg) - air_mass(noon_deg);
    return bright.sun_illuminance * glm::vec3{shown * glm::exp(-more_air * k_optical_depth)};
}

/// The sky when the sun stands at a height, between which it changes exponentially.
struct SkyKey {
    double height_deg;
    glm::vec3 zenith;
    glm::vec3 horizon;
};
constexpr double k_high_deg = 50.0;  ///< from here on the sky is noon's
/// Chosen by eye. Until sunset the zenith falls to a quarter; then, while nature takes a hundredfold away in
/// 6°, a third stays every 4°; below −8° nearly all (see daylight()). The horizon is the mean of all its
/// directions: gold, then rose, then the town's own glow.
const std::array<SkyKey, 8> k_sky{{{-18.0, {0.0009f, 0.0016f, 0.0046f}, {0.0050f, 0.0049f, 0.0066f}},
                                   {-12.0, {0.0011f, 0.0021f, 0.0064f}, {0.0058f, 0.0062f, 0.0094f}},
                                   {-8.0, {0.0026f, 0.0056f, 0.0180f}, {0.0120f, 0.0135f, 0.0220f}},
                                   {-4.0, {0.0088f, 0.0180f, 0.0520f}, {0.0560f, 0.0500f, 0.0560f}},
                                   {0.0, {0.0270f, 0.0480f, 0.1080f}, {0.2100f, 0.1500f, 0.1150f}},
                                   {6.0, {0.0560f, 0.0970f, 0.2020f}, {0.3300f, 0.2850f, 0.2350f}},
                                   {20.0, {0.0920f, 0.1580f, 0.3200f}, {0.3800f, 0.4150f, 0.4450f}},
                                   {k_high_deg, noon().sky_zenith_radiance, noon().sky_horizon_radiance}}};

/// The exposure that goes with the sun at a height.
struct ExposureKey {
    double height_deg;
    double exposure_ev;
};
constexpr std::array<ExposureKey, 7> k_exposures{
    {{-18.0, 3.1}, {-8.0, 3.0}, {-4.0, 2.6}, {0.0, 2.1}, {6.0, 1.3}, {20.0, 0.35}, {45.0, 0.0}}};

/// The keys on both sides of a height, and where it lies between them.
template <class Key>
struct Between {
    const Key& low;
    const Key& high;
    double share;
};
template <class Key>
Between<Key> between(std::span<const Key> keys, double height_deg) {
    std::size_t upper = 1;
    while (upper + 1 < keys.size() && keys[upper].height_deg < height_deg)
        ++upper;
    const Key& low = keys[upper - 1];
    const Key& high = keys[upper];
    return {low, high,
            std::clamp((height_deg - low.height_deg) / (high.height_deg - low.height_deg), 0.0, 1.0)};
}

glm::vec3 exponential_mix(glm::vec3 a, glm::vec3 b, double share) {
    return glm::exp(glm::mix(glm::log(a), glm::log(b), static_cast<float>(share)));
}

/// Irradiance over π on level open ground. Of the sky's √height between horizon and zenith, the
/// cosine-weighted mean is 0.8, as in render/shaders/sky.glsl.
glm::vec3 light_on_ground(const Environment& light) {
    constexpr float k_mean_root = 0.8f;
    const float sine = std::max(light.direction_to_sun.y, 0.0f);
    return light.sun_illuminance * (sine / static_cast<float>(k_pi)) +
           glm::mix(light.sky_horizon_radiance, light.sky_zenith_radiance, k_mean_root);
}

}  // namespace

std::string to_text(TimeOfDay time) {
    if (!time.solar_minutes) return "noon";
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%02d:%02d", *time.solar_minutes / 60, *time.solar_minutes % 60);
    return text.data();
}

std::optional<TimeOfDay> time_from_text(std::string_view text) {
    if (text == "noon") return TimeOfDay{};
    if (text.size() != 5 || text[2] != ':') return std::nullopt;
    for (const std::size_t i : {0u, 1u, 3u, 4u})
        if (text[i] < '0' || text[i] > '9') return std::nullopt;
    const int hours = 10 * (text[0] - '0') + (text[1] - '0');
    const int minutes = 10 * (text[3] - '0') + (text[4] - '0');
    if (hours >= 24 || minutes >= 60) return std::nullopt;
    return TimeOfDay{60 * hours + minutes};
}

float sun_height_sine(TimeOfDay time) {
    return time.solar_minutes ? static_cast<float>(to_sun(*time.solar_minutes).y) : noon().direction_to_sun.y;
}

Environment daylight(TimeOfDay time) {
    if (!time.solar_minutes) return noon();
    const glm::dvec3 direction = to_sun(*time.solar_minutes);
    const double height_deg = degrees(std::asin(direction.y));
    const Between<SkyKey> sky = between<SkyKey>(k_sky, height_deg);
    Environment light;
    light.direction_to_sun = glm::vec3{direction};
    light.sun_illuminance = sun_illuminance(height_deg);
    light.sky_zenith_radiance = exponential_mix(sky.low.zenith, sky.high.zenith, sky.share);
    light.sky_horizon_radiance = exponential_mix(sky.low.horizon, sky.high.horizon, sky.share);
    // The ground's albedo is what makes noon()'s ground of noon()'s light.
    light.ground_radiance = noon().ground_radiance / light_on_ground(noon()) * light_on_ground(light);
    return light;
}

float daylight_exposure_ev(TimeOfDay time) {
    if (!time.solar_minutes) return 0.0f;
    const double height_deg = degrees(std::asin(to_sun(*time.solar_minutes).y));
    const Between<ExposureKey> keys = between<ExposureKey>(k_exposures, height_deg);
    return static_cast<float>(std::lerp(keys.low.exposure_ev, keys.high.exposure_ev, keys.share));
}

}  // namespace rambla::assets
