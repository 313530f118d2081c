#pragma once

#include "assets/process/raster.h"

namespace rambla::assets {

/// Share of a repeated, bilinearly filtered picture whose alpha is at least `cutoff`, found on a grid of at
/// least 2×2 points a texel and 65 536 in all.
[[nodiscard]] double alpha_coverage(const Raster& picture, float cutoff);

/// Raises alpha so that the share of the picture that passes the test is no less than `coverage`, and as far
/// as the picture's values allow it no more: one that is the same everywhere passes as a whole or not at all.
/// Castaño 2010, "Computing alpha mipmaps", but never lowered: thin bars between broad rails would vanish for
/// what the rails have gained.
/// @param cutoff  of the alpha test, in (0, 1]
void keep_coverage(Raster& picture, double coverage, float cutoff);

}  // namespace rambla::assets
