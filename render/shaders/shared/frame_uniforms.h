// What every pass of a frame may need to know (uniform block, std140: vec4 and mat4 only). World here is
// camera-relative: world axes, origin at the eye.
#ifndef RAMBLA_SHARED_FRAME_UNIFORMS_H
#define RAMBLA_SHARED_FRAME_UNIFORMS_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct FrameUniforms {
    mat4 view_from_world;
    mat4 world_from_view;
    mat4 clip_from_view;
    mat4 clip_from_world;
    vec4 unprojection;  // x: 1/a_x, y: 1/a_y, z: b_x, w: b_y of clip_from_view: x_eye = −z_eye·(2·x_w − 1 +
                        // b_x)/a_x
    vec4 depth_scale;       // perspective: z_eye = −x/depth (x = near), y = 0, z = 0; orthographic: z_eye =
                            // y·depth + z, x = 0
    vec4 size_px;           // xy: width, height, zw: their reciprocals
    vec4 direction_to_sun;  // w: padding
    vec4 sun_illuminance;   // w: padding
    vec4 sky_zenith_radiance;   // w: padding
    vec4 sky_horizon_radiance;  // w: padding
    vec4 ground_radiance;       // w: sky visibility
    vec4 exposure;  // x: factor on everything written to HDR targets (pre-exposure), y: its reciprocal, zw:
                    // padding
    vec4 eye_cell;  // xyz: integer cell, w: padding
    vec4 eye_local_m;  // xyz: place in the cell, w: time in seconds
    uvec4 counts;      // x: local lights, y: 1 when orthographic, z: directional lights, w: steps of looks into reliefs
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::FrameUniforms) == 4 * 64 + 12 * 16);
#endif
#endif
