#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/instance.h"
#include "render/shaders/shared/material.h"

layout(std430, binding = BINDING_INSTANCES) readonly buffer InstanceBlock {
    Instance instances[];
};
layout(std430, binding = BINDING_MATERIALS) readonly buffer MaterialBlock {
    Material materials[];
};

/// The default material stands behind the scene's own, and is the one of instances that name none.
uint material_row(Instance instance) {
    return min(instance.material & k_instance_material_mask, uint(materials.length()) - 1u);
}

/// What is left of an instance that fades, [0, 1].
float instance_opacity(Instance instance) {
    return 1.0 - float(instance.material >> k_instance_fade_shift) / 255.0;
}

vec3 world_from_local(Instance instance, vec3 local) {
    vec4 p = vec4(local, 1.0);
    return vec3(dot(instance.row0, p), dot(instance.row1, p), dot(instance.row2, p));
}

vec2 transformed_uv(UvTransform t, vec2 uv0, vec2 uv1) {
    vec2 uv = t.row0.w < 0.5 ? uv0 : uv1;
    return vec2(dot(t.row0.xy, uv) + t.row0.z, dot(t.row1.xy, uv) + t.row1.z);
}
