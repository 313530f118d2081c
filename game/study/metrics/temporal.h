#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "game/study/picture.h"

namespace rambla::game::study {

/// Two frames of one view. Refers to the pictures, does not keep them.
struct FramePair {
    const Picture& before;
    const Picture& after;
};

/// Share of pixels that change between two frames where the reference does not.
/// @param tolerance  linear light; a pixel changes when a channel changes by more. A texel that becomes or
///                   ceases to be finite changes.
/// @return  percent of all pixels, 0 to 100
/// @throws  std::invalid_argument saying both sizes when pictures differ in theirs
[[nodiscard]] double flicker_pct(FramePair reference, FramePair test, double tolerance);

/// How much more an object changes between two frames than it should: the mean absolute change of linear
/// light over its pixels and the three channels, less the same mean of the reference; not below 0.
/// The means are subtracted, not the pictures: a coarser level of detail has its texels elsewhere, so that on
/// the move its pixels change at other places than the reference's without that anything pops.
/// @param object  per pixel, not 0 where the object is (in one of the two frames); width · height
/// @return  linear light, ≥ 0; 0 for an object without pixels. Texels that are not finite count as black.
/// @throws  std::invalid_argument when pictures or mask differ in size
[[nodiscard]] double pop_linear(FramePair reference, FramePair test, std::span<const std::uint8_t> object);

/// The worst of a run; linear light.
struct Pops {
    double max_linear = 0.0;       ///< between successive frames
    double p99_linear = 0.0;       ///< 99th percentile over the run's pairs of successive frames
    double in_100ms_linear = 0.0;  ///< largest between frames 100 ms apart; 0 for a run that is shorter
};

/// Follows one object through a run of frames and keeps those of the last 100 ms.
class PopMeter {
public:
    /// @param frame_s  time between frames in seconds, ≥ 1e-6; 100 ms is rounded to whole frames, one at
    /// least
    /// @throws std::invalid_argument when it is below
    explicit PopMeter(double frame_s);

    /// @param object  pixels that the object covers in this frame, in the test or the reference; a pair is
    ///                compared where it is in either frame
    /// @throws std::invalid_argument when pictures or mask differ in size, from each other or the last frame
    void add(Picture reference, Picture test, std::vector<std::uint8_t> object);

    [[nodiscard]] Pops result() const;

private:
    struct Frame {
        Picture reference;
        Picture test;
        std::vector<std::uint8_t> object;
    };
    [[nodiscard]] static double pop_between(const Frame& before, const Frame& after);

    std::size_t frames_in_100ms_;
    std::deque<Frame> last_{};
    std::vector<double> successive_{};
    std::vector<double> in_100ms_{};
};

}  // namespace rambla::game::study
