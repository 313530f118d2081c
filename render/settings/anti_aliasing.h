#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "assets/parameter.h"

namespace rambla::render {

enum class AntiAliasing : std::uint8_t { none, sobel, edges, fxaa, morphological, taa, ssaa };

/// What the Sobel operator looks for edges in.
enum class SobelOf : std::uint8_t { colour, depth };

enum class AntiAliasingQuality : std::uint8_t { low, medium, high };

struct AntiAliasingParameters {
    AntiAliasing method = AntiAliasing::fxaa;
    SobelOf sobel_of = SobelOf::colour;
    AntiAliasingQuality quality = AntiAliasingQuality::medium;
    bool everywhere = false;
    int samples = 4;
    float history = 0.95f;
    bool clamp = true;
};
inline constexpr std::array<std::string_view, 7> k_anti_aliasing_methods{
    "none", "sobel", "edges", "fxaa", "morphological", "taa", "ssaa"};
inline constexpr std::array<std::string_view, 2> k_sobel_of{"colour", "depth"};
inline constexpr std::array<std::string_view, 3> k_anti_aliasing_qualities{"low", "medium", "high"};

/// Whether a method looks at nothing but the finished picture, and works where it has edges
/// (render/post/edge_smoothing.h).
[[nodiscard]] constexpr bool smooths_edges(AntiAliasing method) {
    return method == AntiAliasing::sobel || method == AntiAliasing::edges || method == AntiAliasing::fxaa ||
           method == AntiAliasing::morphological;
}
/// Whether tone mapping draws a picture of its own, from which the method makes the one that is shown.
[[nodiscard]] constexpr bool needs_display(AntiAliasing method) {
    return smooths_edges(method) || method == AntiAliasing::ssaa;
}

inline constexpr std::array k_anti_aliasing_parameters{
    parameter<&AntiAliasingParameters::method>("aa", k_anti_aliasing_methods,
                                               "How jagged edges are smoothed; taa by the mean of pictures "
                                               "that follow each other within a second."),
    parameter<&AntiAliasingParameters::sobel_of>("of", k_sobel_of, "sobel: what edges are looked for in."),
    parameter<&AntiAliasingParameters::quality>("quality", k_anti_aliasing_qualities,
                                                "fxaa and morphological: how faint edges may be, and how far "
                                                "their ends are looked for."),
    parameter<&AntiAliasingParameters::everywhere>("everywhere", "", 0, 1,
                                                   "Works on all pixels instead of where edges are; the "
                                                   "picture is the same."),
    parameter<&AntiAliasingParameters::samples>("samples", "", 2, 8,
                                                "ssaa: pixels drawn for one shown, across and down."),
    parameter<&AntiAliasingParameters::history>("history", "", 0, 0.98,
                                                "taa: share of earlier pictures in a pixel that stays."),
    parameter<&AntiAliasingParameters::clamp>(
        "clamp", "", 0, 1, "taa: earlier colours are kept within those around a pixel now."),
};

}  // namespace rambla::render
