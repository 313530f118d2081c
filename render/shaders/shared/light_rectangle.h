// Where on the screen a local light can matter (storage block, std430).
#ifndef RAMBLA_SHARED_LIGHT_RECTANGLE_H
#define RAMBLA_SHARED_LIGHT_RECTANGLE_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct LightRectangle {
    vec4 ndc;          // left, bottom, right, top in [−1, 1]
    float depth;       // of the light's point farthest from the eye: pixels behind it are out of reach
    uint light;        // row of the frame's lights
    float near_depth;  // of its nearest point: pixels before that are out of reach, too
    uint padding0;
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::LightRectangle) == 32);
#endif
#endif
