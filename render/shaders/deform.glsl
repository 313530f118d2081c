// Vertices as morph targets and joints move them. Defines: MORPHED, SKINNED; where both are 0, nothing is left of
// this.
#include "scene_buffers.glsl"
#include "render/shaders/shared/deformation.h"

#if MORPHED
layout(std430, binding = BINDING_MORPH_TERMS) readonly buffer MorphTermBlock {
    MorphTerm morph_terms[];
};
/// MorphTargets, and behind them the words of their columns: bits of floats.
layout(std430, binding = BINDING_MORPHS) readonly buffer MorphBlock {
    uint morph_words[];
};

MorphTarget morph_target(uint index) {
    uint word = k_morph_target_words * index;
    return MorphTarget(morph_words[word], morph_words[word + 1u], morph_words[word + 2u],
                       morph_words[word + 3u]);
}

/// What a target's column holds for this vertex; nothing where there is no such column.
vec3 morph_delta(MorphTarget target, uint column, uint first) {
    if ((target.columns & column) == 0u) return vec3(0.0);
    uint word = first + 3u * uint(gl_VertexID);
    return uintBitsToFloat(uvec3(morph_words[word], morph_words[word + 1u], morph_words[word + 2u]));
}
#endif

/// glTF 2.0, 3.7.2.2: deltas are added by weight, before skinning.
void morph(Instance instance, inout vec3 position) {
#if MORPHED
    for (uint i = instance.morphs; morph_terms[i].weight != 0.0; ++i) {
        MorphTarget target = morph_target(morph_terms[i].target);
        position += morph_terms[i].weight * morph_delta(target, k_morph_positions, target.positions);
    }
#endif
}

void morph(Instance instance, inout vec3 position, inout vec3 normal, inout vec3 tangent) {
#if MORPHED
    for (uint i = instance.morphs; morph_terms[i].weight != 0.0; ++i) {
        MorphTarget target = morph_target(morph_terms[i].target);
        float weight = morph_terms[i].weight;
        position += weight * morph_delta(target, k_morph_positions, target.positions);
        normal += weight * morph_delta(target, k_morph_normals, target.normals);
        tangent += weight * morph_delta(target, k_morph_tangents, target.tangents);
    }
#endif
}

#if SKINNED
layout(std430, binding = BINDING_JOINTS) readonly buffer JointBlock {
    JointMatrix joint_matrices[];
};
layout(location = ATTRIBUTE_JOINTS) in uvec4 vertex_joints;
layout(location = ATTRIBUTE_WEIGHTS) in vec4 vertex_weights;
#endif

/// The instance as this vertex finds it: of a skinned mesh, its rows are the mean of its joints'. Positions,
/// normals and tangents then transform by these rows like those of any other mesh.
Instance skinned(Instance instance) {
#if SKINNED
    instance.row0 = instance.row1 = instance.row2 = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        JointMatrix joint = joint_matrices[instance.joints + vertex_joints[i]];
        instance.row0 += vertex_weights[i] * joint.row0;
        instance.row1 += vertex_weights[i] * joint.row1;
        instance.row2 += vertex_weights[i] * joint.row2;
    }
#endif
    return instance;
}
