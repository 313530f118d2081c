#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "assets/parameter.h"

namespace rambla::render {

enum class ToneCurve : std::uint8_t { reinhard, extended, filmic, aces, agx };

/// What a curve is applied to.
enum class ToneOn : std::uint8_t { channels, luminance };

/// How scene colour is stored until it is shown.
enum class SceneColourFormat : std::uint8_t { rgba16f, r11g11b10f };

struct ToneParameters {
    ToneCurve curve = ToneCurve::aces;
    ToneOn on = ToneOn::channels;
    float white = 3.0f;
    bool estimate = false;
    float gamma = 1.0f;
    float brightness = 1.0f;
    float blue_shift = 0.0f;
    bool dither = true;
    SceneColourFormat format = SceneColourFormat::rgba16f;
};
inline constexpr std::array<std::string_view, 5> k_tone_curves{"reinhard", "extended", "filmic", "aces",
                                                               "agx"};
inline constexpr std::array<std::string_view, 2> k_tone_on{"channels", "luminance"};
inline constexpr std::array<std::string_view, 2> k_scene_colour_formats{"rgba16f", "r11g11b10f"};
inline constexpr std::array k_tone_parameters{
    parameter<&ToneParameters::curve>("tonemap", k_tone_curves, "Curve from scene light to the display."),
    parameter<&ToneParameters::on>("on", k_tone_on,
                                   "Whether the curve changes each channel or the luminance alone."),
    parameter<&ToneParameters::white>("white", "", 0.25, 64,
                                      "extended and filmic: scene light that becomes display white."),
    parameter<&ToneParameters::estimate>("estimate", "", 0, 1,
                                         "extended: scale and white from the picture's own luminances "
                                         "(Reinhard 2002)."),
    parameter<&ToneParameters::gamma>("gamma", "", 0.25, 4,
                                      "On top of sRGB: above 1 lifts the middle tones."),
    parameter<&ToneParameters::brightness>("brightness", "", 0.25, 4,
                                           "Factor on display light, before it is encoded."),
    parameter<&ToneParameters::blue_shift>(
        "blue_shift", "", 0, 1, "How far dark places lose their colour to the blue of night sight."),
    parameter<&ToneParameters::dither>("dither", "", 0, 1,
                                       "Noise of half a step of the display, so that gradients do not band."),
    parameter<&ToneParameters::format>("format", k_scene_colour_formats,
                                       "How scene colour is stored: half floats, or 32 bits a pixel."),
};

}  // namespace rambla::render
