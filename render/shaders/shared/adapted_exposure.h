// What exposure.comp.glsl makes of a picture's luminances, and tone mapping uses.
#ifndef RAMBLA_SHARED_ADAPTED_EXPOSURE_H
#define RAMBLA_SHARED_ADAPTED_EXPOSURE_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
// Lives from frame to frame (storage block, std430; uniform block, std140).
struct AdaptedExposure {
    double ev;  // departure from the exposure that scene colour has; in double precision, since a frame of
                // 0.1 ms moves it by less than a float of some stops resolves
    double padding0;
    vec4 shown;  // x: factor on scene colour before its curve; y: scene light, with it, that becomes white
    vec4 seen;  // x: log-average luminance, y: pixels that were no numbers, z, w: 1 % and 99 % percentiles of
                // luminance, 0 where nobody counts them
};

// What a frame's exposure follows from (uniform block, std140).
struct ExposureStep {
    vec4 follows;  // x, y: share of the way to a brighter, or darker, picture that this frame goes; z: key,
                   // w: strength
    vec4 bounds;   // x: farthest departure in EV; y: δ; z: what divides the sum to make it a mean; w: pixels
                   // for one counted
    vec4 curve;    // x: scene light that becomes white, unless it is estimated; yzw: padding
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::AdaptedExposure) == 48);
static_assert(sizeof(rambla::render::shared::ExposureStep) == 48);
#endif
#endif
