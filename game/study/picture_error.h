#pragma once

#include <vector>

#include "assets/image.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// How far a picture is from the reference as an eye before a screen sees it: `flip_mean`, `psnr_db`, and
/// `wrong_pixels_pct`, the share of the pixels of which a channel of what the screen is sent differs by more
/// than 4 of 255.
/// @param reference, test  rgba8 pictures of one size
[[nodiscard]] std::vector<Metric> display_metrics(const assets::Image& reference, const assets::Image& test);

/// Metrics of several pictures of one grade as one: the mean of each.
[[nodiscard]] std::vector<Metric> mean_metrics(const std::vector<std::vector<Metric>>& pictures);

}  // namespace rambla::game::study
