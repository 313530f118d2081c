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

}  // namespace rambla::game::study
