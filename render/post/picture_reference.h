#pragma once

#include <glm/glm.hpp>
#include <span>

#include "render/settings/tone.h"

namespace rambla::render {

/// What the shaders between scene and display compute, in double precision and straight from the
/// publications: studies and tests hold the GPU against it.

/// Log-average luminance of a linear image: exp(mean(ln(δ + Y))).
/// @param image  linear Rec. 709 light, any size > 0; texels that are no numbers, or of negative luminance,
/// count as 0
/// @param delta  keeps ln finite on black, in the image's units; > 0
/// @return       luminance in the image's units, > 0; equals delta for an all-black image
/// Reinhard et al. 2002, "Photographic tone reproduction for digital images", eq. 1.
[[nodiscard]] double log_average_luminance(std::span<const glm::vec3> image, double delta);

/// Luminance that a share of the texels does not exceed; texels as above. @param share  in [0, 1]
[[nodiscard]] double luminance_percentile(std::span<const glm::vec3> image, double share);

/// Scale and white of extended Reinhard for a picture.
struct EstimatedCurve {
    double key = 0.18;   ///< what the average becomes
    double white = 1.0;  ///< scene light, scaled like that, that becomes display white
};
/// Reinhard 2002, "Parameter estimation for photographic tone reproduction"; guarded as in exposure.glsl.
[[nodiscard]] EstimatedCurve estimate_curve(double average, double darkest, double brightest);

/// Display light in [0, 1]^3 of exposed scene light ≥ 0. @param white  of ToneParameters
[[nodiscard]] glm::dvec3 tone_mapped(const glm::dvec3& scene, ToneCurve curve, ToneOn on, double white);

/// Linear light in [0, 1] to sRGB (IEC 61966-2-1).
[[nodiscard]] double srgb_encoded(double linear);

}  // namespace rambla::render
