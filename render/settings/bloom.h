#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "assets/parameter.h"

namespace rambla::render {

enum class BloomMethod : std::uint8_t { off, pyramid, iterated, kawase, dual };

/// Light that very bright places shed around them, as eyes and lenses scatter it.
struct BloomParameters {
    BloomMethod method = BloomMethod::pyramid;
    float threshold = 1.5f;
    float knee = 0.5f;
    float intensity = 0.1f;
    int passes = 6;
    bool fireflies = true;
    bool corona = false;
};
inline constexpr std::array<std::string_view, 5> k_bloom_methods{"off", "pyramid", "iterated", "kawase",
                                                                 "dual"};
inline constexpr std::array k_bloom_parameters{
    parameter<&BloomParameters::method>("bloom", k_bloom_methods,
                                        "Glow about what is very bright: how light is spread."),
    parameter<&BloomParameters::threshold>("threshold", "", 0, 64,
                                           "Exposed luminance above which things glow; 1 is about white."),
    parameter<&BloomParameters::knee>(
        "knee", "", 0, 1, "Share of the threshold on either side of it within which glow sets in."),
    parameter<&BloomParameters::intensity>("intensity", "", 0, 1,
                                           "Share of the light above the threshold that is spread."),
    parameter<&BloomParameters::passes>("passes", "", 1, 32, "iterated and kawase: how often it is blurred."),
    parameter<&BloomParameters::fireflies>(
        "fireflies", "", 0, 1, "Lone very bright pixels count less, so that they do not flicker."),
    parameter<&BloomParameters::corona>("corona", "", 0, 1, "Rays and a halo about lamps that are seen."),
};

}  // namespace rambla::render
