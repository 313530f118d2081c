#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "assets/parameter.h"

namespace rambla::render {

enum class BloomMethod : std::uint8_t { off, pyramid, iterated, kawase, dual };

/// Light that very bright places shed around them, as eyes and lenses scatter it: `intensity` times the light
/// above the threshold, spread by the sum of four Gaussians (render/post/bloom_kernel.h).
struct BloomParameters {
    BloomMethod method = BloomMethod::pyramid;
    /// Luminance of pre-exposed scene colour: the Frame's light times 2^ev. What automatic exposure
    /// multiplies the picture by is found from this very frame and known to tone mapping alone, so that what
    /// glows depends on the scene and not on where one looks.
    float threshold = 1.5f;
    float knee = 0.5f;  ///< half the width of the soft onset, as a share of the threshold
    float intensity = 0.2f;
    int passes = 6;  ///< of `iterated` and `kawase`
    /// Pixels that are alone in being very bright count less (Karis' weights). Without, the glow has exactly
    /// the energy of what is bright, and flickers as pixels of glints and of far lamps come and go.
    bool fireflies = true;
    bool corona = false;  ///< needs no bloom: it is made of the Frame's lights
};
inline constexpr std::array<std::string_view, 5> k_bloom_methods{"off", "pyramid", "iterated", "kawase",
                                                                 "dual"};
inline constexpr std::array k_bloom_parameters{
    parameter<&BloomParameters::method>("bloom", k_bloom_methods,
                                        "Glow about what is very bright: how light is spread."),
    parameter<&BloomParameters::threshold>("threshold", "", 0, 64,
                                           "Luminance above which things glow, at the exposure's ev; 1 is "
                                           "about white."),
    parameter<&BloomParameters::knee>(
        "knee", "", 0, 1, "Share of the threshold on either side of it within which glow sets in."),
    parameter<&BloomParameters::intensity>("intensity", "", 0, 1,
                                           "Share of the light above the threshold that is spread."),
    parameter<&BloomParameters::passes>("passes", "", 1, 32, "iterated and kawase: how often it is blurred."),
    parameter<&BloomParameters::fireflies>(
        "fireflies", "", 0, 1, "Lone very bright pixels glow less, so that the glow does not flicker."),
    parameter<&BloomParameters::corona>("corona", "", 0, 1, "Rays and a halo about lamps that are seen."),
};

}  // namespace rambla::render
