// One drawn thing: the image of systems::Instance. A shader's index is gl_BaseInstanceARB + gl_InstanceID.
#ifndef RAMBLA_SHARED_INSTANCE_H
#define RAMBLA_SHARED_INSTANCE_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
SHARED_CONSTANT k_instance_material_mask = 0xffffffu;
SHARED_CONSTANT k_instance_fade_shift = 24u;

struct Instance {
    vec4 row0;  // rows of the affine camera-relative world_from_local: world.x = dot(row0, vec4(local, 1))
    vec4 row1;
    vec4 row2;
    uint material;  // masked: row of the materials; from the shift on: how far it has faded, of 255
    uint object;
    uint joints;  // skinned: row of the joints that is joint 0
    uint morphs;  // morphed: first of its morph terms
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::Instance) == 64);
#endif
#endif
