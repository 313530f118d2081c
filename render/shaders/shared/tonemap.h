#ifndef RAMBLA_SHARED_TONEMAP_H
#define RAMBLA_SHARED_TONEMAP_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
// Of tone mapping (uniform block, std140).
struct TonemapConstants {
    vec4 curve;   // x: scene light that becomes white, y: factor on display light, z: power of encoded light,
                  // w: blue shift
    vec4 target;  // x: 1 writes luma into alpha for anti-aliasing, 0 writes 1; y: exposure of scene colour;
                  // zw: padding
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::TonemapConstants) == 32);
#endif
#endif
