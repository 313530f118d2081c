// Casters into the sun's map. Define ALPHA_MASK: passes on what the cut-out needs; others: deform.glsl.
#include "deform.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 local_position;
#if ALPHA_MASK
layout(location = ATTRIBUTE_UV0) in vec2 uv0;
layout(location = ATTRIBUTE_UV1) in vec2 uv1;
layout(location = ATTRIBUTE_COLOUR) in vec4 vertex_colour;
out vec2 mask_uv;
out float mask_alpha;
flat out uint mask_material;
#endif

layout(std140, binding = BINDING_PASS_UNIFORMS) uniform CasterBlock {
    mat4 clip_from_world;
};

void main() {
    Instance instance = skinned(instances[gl_BaseInstanceARB + gl_InstanceID]);
    vec3 position = local_position;
    morph(instance, position);
    gl_Position = clip_from_world * vec4(world_from_local(instance, position), 1.0);
#if ALPHA_MASK
    mask_material = material_row(instance);
    Material m = materials[mask_material];
    mask_uv = transformed_uv(m.base_colour_uv, uv0, uv1);
    mask_alpha = m.base_colour.a * vertex_colour.a;
#endif
}
