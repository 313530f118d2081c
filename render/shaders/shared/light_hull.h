// A convex solid around all that a local light reaches (storage block, std430). Which one its axes make, and
// of which vertices, is said in render/passes/light_hull.h.
#ifndef RAMBLA_SHARED_LIGHT_HULL_H
#define RAMBLA_SHARED_LIGHT_HULL_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct LightHull {
    vec4 origin;  // xyz: camera-relative metres, w: 1
    mat4 axes;    // xyz of each column: metres, w: 0; a vertex lies at origin + axes · its shares
    uint light;   // row of the frame's lights
    uint padding0;
    uint padding1;
    uint padding2;
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::LightHull) == 96);
#endif
#endif
