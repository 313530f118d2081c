#pragma once

#include "assets/process/raster.h"

namespace rambla::assets {

/// Share of a repeated, bilinearly filtered picture whose alpha is at least `cutoff`, found on a grid of at
/// least 2×2 points a texel and 65 536 in all.
[[nodiscard]] double alpha_coverage(const Raster& picture, float cutoff);

/// Scales alpha so that the share of the picture that passes the test becomes `coverage` again, as far as the
/// picture's values allow it: one that is the same everywhere passes as a whole or not at all. Castaño 2010,
/// "Computing alpha mipmaps".
/// @param cutoff  of the alpha test, in (0, 1]
void keep_coverage(Raster& picture, double coverage, float cutoff);

}  // namespace rambla::assets
