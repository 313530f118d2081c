#pragma once

#include <cstdint>
#include <vector>

#include "game/study/picture.h"

namespace rambla::game::study {

/// Pixels that one degree of the viewer's field of vision covers, on the screen straight ahead.
/// Andersson et al. 2020: p = d · (W_px / W_m) · π / 180.
/// @param distance_m  from eye to screen, > 0
[[nodiscard]] constexpr double pixels_per_degree(double distance_m, double width_m, double width_px) {
    constexpr double k_degree_rad = 3.14159265358979323846 / 180.0;
    return distance_m * (width_px / width_m) * k_degree_rad;
}

/// A screen of 3840 pixels on 0.7 m, seen from 0.7 m, as in the paper: 67.02.
inline constexpr double k_flip_pixels_per_degree = pixels_per_degree(0.7, 0.7, 3840.0);

/// What eyes see of the difference when two pictures alternate.
struct Flip {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> map{};  ///< per pixel, row-major, 0 (no difference) to 1 (the largest there is)
    double mean = 0.0;         ///< of the map; 0 for pictures without texels
};

/// ꟻLIP of what a display shows. Both pictures are blurred as the eye does at that distance, their colours
/// compared (HyAB in L*a*b* with the Hunt effect), and the result enlarged where edges or points differ.
/// @param reference, test  linear light; what lies outside of [0, 1] is clamped, and beyond its border a
///                         picture goes on with its outermost texels. A texel that is not finite is filtered
///                         as black; where one picture alone has such a texel the map is 1.
/// @param pixels_per_degree  1 to 10 000
/// @throws std::invalid_argument saying both sizes when they differ, or that pixels_per_degree is out of
/// range Symmetric to the last bit: exchanging the pictures changes nothing. Andersson, Nilsson,
/// Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "ꟻLIP: A Difference Evaluator for Alternating
/// Images". White against black is 0.967 by its formulas: 1 is green against blue.
[[nodiscard]] Flip ldr_flip(const Picture& reference, const Picture& test,
                            double pixels_per_degree = k_flip_pixels_per_degree);

/// Exposures at which a picture of high dynamic range is looked at, evenly spaced.
struct FlipExposures {
    double start_ev = 0.0;  ///< log2 of the factor that brings the largest luminance to 0.85 on the display
    double stop_ev = 0.0;   ///< the same of the median
    std::uint32_t count = 2;

    /// @param i  below count
    [[nodiscard]] constexpr double ev(std::uint32_t i) const {
        return start_ev + (stop_ev - start_ev) * i / (count - 1);
    }
    [[nodiscard]] friend bool operator==(const FlipExposures&, const FlipExposures&) = default;
};

/// From the largest luminance to the median, at most one stop apart: max(2, ⌈stop − start⌉) of them.
/// @param reference  linear light in any unit; negative values count as 0, texels that are not finite are
/// left
///                   out. The median is taken for no less than 2^-23 of the largest luminance, so that a
///                   picture that is black for the most part has 23 exposures rather than endlessly many.
/// @return  2 exposures of 0 EV when there is no light
/// Andersson, Nilsson, Shirley and Akenine-Möller 2021, "Visualizing Errors in Rendered High Dynamic Range
/// Images", on start and stop exposures, with the tone curve of Narkowicz 2015, "ACES Filmic Tone Mapping
/// Curve". (A constant factor before that curve, as some use, cancels: the exposures follow from its
/// inverse.)
[[nodiscard]] FlipExposures flip_exposures(const Picture& reference);

/// ꟻLIP of pictures of high dynamic range: the largest that ldr_flip() finds of a pixel at any of
/// flip_exposures(reference), both pictures tone mapped. Differences above display white are seen too.
/// @param reference, test  linear light in one unit, any; that unit does not matter. Negative values count as
///                         0, texels that are not finite as in ldr_flip(). When the reference is all black,
///                         exposures are taken from the test.
/// @param pixels_per_degree  1 to 10 000
/// @throws std::invalid_argument as ldr_flip()
/// Not symmetric: the exposures are the reference's.
/// Andersson et al. 2021.
[[nodiscard]] Flip hdr_flip(const Picture& reference, const Picture& test,
                            double pixels_per_degree = k_flip_pixels_per_degree);

}  // namespace rambla::game::study
