// How a picture follows from the one before it (uniform block, std140): render/temporal_history.h.
#ifndef RAMBLA_SHARED_TEMPORAL_H
#define RAMBLA_SHARED_TEMPORAL_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct TemporalConstants {
    mat4 past_from_present;     // of (x, y, depth, 1) in clip space
    mat4 past_clip_from_world;  // of points relative to the eye as it was
    vec4 jitter;                // xy: how far the picture is shifted, pixels; zw: padding
    vec4 history;  // x: least share of the present in a pixel; y: pre-exposure now over then; z: 1 where
                   // there is a past, else 0; w: padding
    uvec4 counts;  // x: things that moved; yzw: padding
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::TemporalConstants) == 2 * 64 + 3 * 16);
#endif
#endif
