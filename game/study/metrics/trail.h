#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "game/study/picture.h"

namespace rambla::game::study {

/// How long a way of drawing that uses earlier pictures shows traces behind what moves. It follows pixels
/// that something moving has uncovered, by the number of frames since, and compares how far the way's picture
/// is from the reference with how far a picture of the same frame without history is: only what is worse than
/// that is a trace, so that edges which no anti-aliasing gets right do not count.
///
///     frame        0   1   2   3   4
///     the pixel    M   M   s   s   s      M: something moving, s: still
///     shows for    –   –   1   2   3      frames what was behind it
class TrailMeter {
public:
    /// @param longest_frames  ages up to this are followed, > 0
    explicit TrailMeter(std::uint32_t longest_frames);

    /// The next frame of a sequence.
    /// @param plain   the same frame without history and without anti-aliasing
    /// @param moving  per pixel, not 0 where something moving is seen
    /// @throws std::invalid_argument when sizes differ, from each other or from the last frame's
    void add(const Picture& reference, const Picture& plain, const Picture& test,
             std::span<const std::uint8_t> moving);

    /// Mean over uncovered pixels of |test − reference| − |plain − reference| of what a display is sent
    /// (sRGB-encoded, 0 to 1, mean of the channels); element 0 is of the first frame that shows them again.
    /// 0 where no pixel is so old.
    [[nodiscard]] std::vector<double> excess_display() const;
    /// Pixels that elements of excess_display() are means of.
    [[nodiscard]] const std::vector<std::uint64_t>& pixels() const { return pixels_; }

private:
    std::vector<double> sums_;
    std::vector<std::uint64_t> pixels_;
    std::vector<std::uint32_t> ages_{};  ///< per pixel: frames since it was uncovered; see trail.cpp
};

/// Number of frames after which the excess stays within a tolerance: 0 if it always is.
/// @param excess_display  as TrailMeter has it
[[nodiscard]] std::uint32_t trail_frames(std::span<const double> excess_display, double tolerance);

}  // namespace rambla::game::study
