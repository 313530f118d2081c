// A light: the image of systems::FrameLight (whose vec3 and float neighbours fill the vec4s here).
// Directional lights follow the point and spot lights in the buffer.
#ifndef RAMBLA_SHARED_LIGHT_H
#define RAMBLA_SHARED_LIGHT_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct Light {
    vec4 position_radius;      // xyz camera-relative metres, w: its light is zero from here on
    vec4 intensity_cos_outer;  // xyz illuminance · m², w: −2 for point lights, so that the cone never cuts
    vec4 direction_cos_inner;  // xyz where it shines, unit length
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::Light) == 48);
#endif
#endif
