#pragma once

#include "game/study/picture.h"
#include "render/settings/bloom.h"

namespace rambla::game::study {

/// The light of a picture that glows: what exceeds the threshold, with the knee of
/// render/shaders/bloom_bright.glsl.
/// @param exposed  linear light times 2^ev
[[nodiscard]] Picture glowing_part(const Picture& exposed, const render::BloomParameters& bloom);

/// Light spread by bloom's point-spread function, in double precision: the mean of four Gaussians as wide as
/// render::k_bloom_sigmas_px say, none of them cut off. Nothing is known beyond the borders: what is inside
/// counts for it.
[[nodiscard]] Picture spread_exactly(const Picture& light);

/// The share `intensity` of the glowing part, spread.
[[nodiscard]] Picture exact_glow(const Picture& exposed, const render::BloomParameters& bloom);

[[nodiscard]] Picture scaled(Picture light, float factor);
[[nodiscard]] Picture sum_of(const Picture& a, const Picture& b);

/// Sum over pixels and channels.
[[nodiscard]] double energy(const Picture& light);
/// The same of the absolute difference.
[[nodiscard]] double change(const Picture& before, const Picture& after);
/// Root of the mean square error, in percent of the root of the exact light's mean square.
[[nodiscard]] double relative_rms_pct(const Picture& exact, const Picture& found);

}  // namespace rambla::game::study
