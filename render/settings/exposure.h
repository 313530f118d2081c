#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "assets/parameter.h"

namespace rambla::render {

enum class ExposureMode : std::uint8_t { fixed, automatic };

/// How the average luminance of a picture is found. The last is the mip chain that stores half floats.
enum class LuminanceMethod : std::uint8_t { chain, compute, mips, mips16 };

/// What scene light is multiplied by before tone mapping: 2^ev, and with `automatic` times a factor that
/// follows the picture's average luminance in time.
struct ExposureParameters {
    ExposureMode mode = ExposureMode::automatic;
    float ev = 0.0f;
    LuminanceMethod luminance = LuminanceMethod::chain;
    float delta = 1e-4f;
    float key = 0.085f;     ///< of the street at noon, whose exposure is right as it is
    float strength = 0.4f;  ///< a dark view of the street at night gets 0.7 EV: more to see, and still night
    float range_ev = 4.0f;
    float up_s = 1.2f;
    float down_s = 0.4f;
};
inline constexpr std::array<std::string_view, 2> k_exposure_modes{"fixed", "auto"};
inline constexpr std::array<std::string_view, 4> k_luminance_methods{"chain", "compute", "mips", "mips16"};
inline constexpr std::array k_exposure_parameters{
    parameter<&ExposureParameters::mode>(
        "exposure", k_exposure_modes,
        "Brightness of the picture: as the light wants it, or also following "
        "what is seen, as eyes do."),
    parameter<&ExposureParameters::ev>("ev", "EV", -16, 16,
                                       "Exposure, which auto departs from; 0 shows white under the noon sun "
                                       "as white."),
    parameter<&ExposureParameters::luminance>("luminance", k_luminance_methods,
                                              "auto: how the average is taken, by passes that average 4x4 "
                                              "pixels, by a compute shader, or, to compare with, by mip "
                                              "levels of floats or half floats, which are right only for "
                                              "sizes that are powers of two."),
    parameter<&ExposureParameters::delta>("delta", "", 1e-6, 1,
                                          "auto: added to each luminance, so that black has a logarithm."),
    parameter<&ExposureParameters::key>("key", "", 0.01, 1,
                                        "auto: average luminance, exposed by ev, that needs no change."),
    parameter<&ExposureParameters::strength>("strength", "", 0, 1,
                                             "auto: share of the difference to the key that is made up for."),
    parameter<&ExposureParameters::range_ev>("range", "EV", 0, 10, "auto: farthest from ev, up and down."),
    parameter<&ExposureParameters::up_s>(
        "up", "s", 0, 60, "auto: time in which 63 % of a change to a brighter picture is done."),
    parameter<&ExposureParameters::down_s>("down", "s", 0, 60,
                                           "auto: the same of a change to a darker picture."),
};

}  // namespace rambla::render
