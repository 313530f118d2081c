// Vertices of the G-buffer and blend passes.
#include "frame.glsl"
#include "scene_buffers.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 local_position;
layout(location = ATTRIBUTE_NORMAL) in vec3 local_normal;
layout(location = ATTRIBUTE_TANGENT) in vec4 local_tangent;
layout(location = ATTRIBUTE_UV0) in vec2 uv0;
layout(location = ATTRIBUTE_UV1) in vec2 uv1;
layout(location = ATTRIBUTE_COLOUR) in vec4 vertex_colour;

out MeshVaryings {
    vec3 position;
    vec3 normal;
    vec4 tangent;
    vec2 uv0;
    vec2 uv1;
    vec4 colour;
    flat uint material;
} vertex;

void main() {
    Instance instance = instances[gl_BaseInstanceARB + gl_InstanceID];
    vec3 world = world_from_local(instance, local_position);
    gl_Position = frame.clip_from_world * vec4(world, 1.0);

    // Normals transform by the inverse transpose, which is the cofactor matrix over the determinant; of the latter
    // only the sign matters here, and a singular matrix needs no division.
    vec3 r0 = instance.row0.xyz, r1 = instance.row1.xyz, r2 = instance.row2.xyz;
    float handedness = dot(r0, cross(r1, r2)) < 0.0 ? -1.0 : 1.0;
    vec3 cofactor_normal = vec3(dot(cross(r1, r2), local_normal), dot(cross(r2, r0), local_normal),
                                dot(cross(r0, r1), local_normal));
    vertex.position = world;
    // Scaled to the length 1 here so that interpolation weighs all three corners alike.
    vertex.normal = handedness * cofactor_normal * inversesqrt(max(dot(cofactor_normal, cofactor_normal), 1e-30));
    vertex.tangent = vec4(dot(r0, local_tangent.xyz), dot(r1, local_tangent.xyz), dot(r2, local_tangent.xyz),
                          handedness * local_tangent.w);
    vertex.uv0 = uv0;
    vertex.uv1 = uv1;
    vertex.colour = vertex_colour;
    vertex.material = material_row(instance);
}
