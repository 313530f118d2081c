#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assets/processed.h"
#include "game/study/in_turns.h"
#include "game/study/picture.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// What sun and lamps make of a scene without textures and without shadows, as a picture of a frame, computed
/// on the CPU in double precision: at what the ray through each pixel's middle hits, with every light, by
/// GGX.
class LightingReference {
public:
    /// @param processed  what was made of the stage's scene
    LightingReference(Stage& stage, const assets::ProcessedScene& processed, const systems::Eye& eye);

    /// Draws the same in a grade – without shadows, sky light and anti-aliasing, which the reference does not
    /// have – and compares as lighting_errors() does, at the stage's exposure.
    [[nodiscard]] std::vector<Metric> error_of(StudyContext& context, Stage& stage,
                                               const PictureGrade& grade) const;

private:
    systems::Eye eye_;
    Picture picture_;
    std::vector<std::uint32_t> objects_;  ///< assets::k_none: sky
};

/// `flip_mean` (HDR), `psnr_db` at the exposure, `error_p99_linear` of the radiance over its own value plus a
/// hundredth of white, and `compared_pct`, the share of the pixels: sky is left out, and so is what shows
/// another object than the ray hits, which is on silhouettes. Where nothing is left, `compared_pct` alone.
/// @param expected_objects, found_objects  of each pixel; assets::k_none: sky, black in `expected`
[[nodiscard]] std::vector<Metric> lighting_errors(const Picture& expected,
                                                  std::span<const std::uint32_t> expected_objects,
                                                  Picture found, std::span<const std::uint32_t> found_objects,
                                                  float exposure_ev);

}  // namespace rambla::game::study
