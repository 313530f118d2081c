// The sun's shadow map as shaders look it up (uniform block, std140).
#ifndef RAMBLA_SHARED_SUN_SHADOW_H
#define RAMBLA_SHARED_SUN_SHADOW_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct SunShadow {
    mat4 map_from_world;  // camera-relative world to [0, 1]³: texture coordinates, and depth, 1 nearest to
                          // the sun
    vec4 size_texels;     // xy: width, height of the map, zw: their reciprocals
    vec4 bias_m;  // x: along the normal, for a surface along the light; y: towards the sun; zw: padding
    vec4 fade;    // x: distance where shadows begin to fade, y: 1/length of the fade, 1/m; zw: padding
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::SunShadow) == 64 + 3 * 16);
#endif
#endif
