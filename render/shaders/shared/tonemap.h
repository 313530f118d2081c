#ifndef RAMBLA_SHARED_TONEMAP_H
#define RAMBLA_SHARED_TONEMAP_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct TonemapConstants {
    vec4 alpha;  // x: 1 writes luma into alpha for anti-aliasing, 0 writes 1; yzw: padding
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::TonemapConstants) == 16);
#endif
#endif
