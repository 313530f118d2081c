// What moves the vertices of skinned and morphed meshes: images of systems::JointMatrix and
// systems::MorphTerm (storage blocks, std430).
#ifndef RAMBLA_SHARED_DEFORMATION_H
#define RAMBLA_SHARED_DEFORMATION_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN
struct JointMatrix {
    vec4 row0;  // rows of the affine camera-relative map from the mesh to where one joint brings it
    vec4 row1;
    vec4 row2;
};

struct MorphTerm {
    uint target;   // counted over all meshes of the scene
    float weight;  // 0 ends a list of terms
};

// Where the words of a target begin: three per vertex, so that vertex v, as gl_VertexID counts it, finds its
// own at first + 3 * v. Modulo 2^32, as vertices before the mesh count too.
struct MorphTarget {
    uint positions;
    uint normals;
    uint tangents;
    uint columns;  // k_morph_…: which of them there are
};

SHARED_CONSTANT k_morph_positions = 1u;
SHARED_CONSTANT k_morph_normals = 2u;
SHARED_CONSTANT k_morph_tangents = 4u;
SHARED_CONSTANT k_morph_target_words = 4u;  // size of a MorphTarget
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::JointMatrix) == 48);
static_assert(sizeof(rambla::render::shared::MorphTerm) == 8);
static_assert(sizeof(rambla::render::shared::MorphTarget) ==
              sizeof(std::uint32_t) * rambla::render::shared::k_morph_target_words);
#endif
#endif
