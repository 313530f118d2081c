#pragma once

#include "game/study/picture.h"

namespace rambla::game::study {

/// Peak signal-to-noise ratio of what a display is sent: 10·log10(1 / mean squared difference), the mean over
/// all channels of all texels, their values sRGB-encoded in [0, 1] without rounding to bytes.
/// @param reference, test  linear light; what lies outside of [0, 1] is clamped. A texel that is not finite
/// in
///                         one of them alone is as wrong as can be (a difference of 1 in all channels); where
///                         both are not, they agree.
/// @return  dB, from 0 (black against white); infinity for equal pictures and for those without texels
/// @throws  std::invalid_argument saying both sizes when they differ
/// Symmetric.
[[nodiscard]] double psnr_db(const Picture& reference, const Picture& test);

}  // namespace rambla::game::study
