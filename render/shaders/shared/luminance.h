// How the luminances of a picture are summed up and counted.
#ifndef RAMBLA_SHARED_LUMINANCE_H
#define RAMBLA_SHARED_LUMINANCE_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
// What summing needs to know (uniform block, std140).
struct LuminanceConstants {
    vec4 delta;    // x: added to each luminance, so that black has a logarithm; yzw: padding
    uvec4 groups;  // x, y: workgroups across and down, z: of both, w: padding
};

// A histogram of log2 of luminance: bins of 1/28 of a stop, from below the least δ to above the largest half.
SHARED_CONSTANT k_luminance_bins = 1024u;

// Pixels along the edge of the square that a workgroup sums or counts, and invocations along it.
SHARED_CONSTANT k_luminance_square_px = 64u;
SHARED_CONSTANT k_luminance_group = 16u;
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::LuminanceConstants) == 32);
#endif
#endif
