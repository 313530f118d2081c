// Vertices of all passes that draw the scene's surfaces for an eye. Defines: those of material.glsl and deform.glsl; MOTION:
// also where they were in the picture before.
#include "frame.glsl"
#include "deform.glsl"
#ifdef MOTION
#include "motion.glsl"
#endif

layout(location = ATTRIBUTE_POSITION) in vec3 local_position;
layout(location = ATTRIBUTE_NORMAL) in vec3 local_normal;
layout(location = ATTRIBUTE_TANGENT) in vec4 local_tangent;
layout(location = ATTRIBUTE_UV0) in vec2 uv0;
layout(location = ATTRIBUTE_UV1) in vec2 uv1;
layout(location = ATTRIBUTE_COLOUR) in vec4 vertex_colour;

#define VARYING out
#include "mesh_varyings.glsl"

invariant gl_Position;  ///< the depth pre-pass and those that shade must agree to the bit

void main() {
    Instance instance = skinned(instances[gl_BaseInstanceARB + gl_InstanceID]);
    vec3 position = local_position;
    vec3 normal = local_normal;
    vec4 tangent = local_tangent;
    morph(instance, position, normal, tangent.xyz);
    vec3 world = world_from_local(instance, position);
    gl_Position = frame.clip_from_world * vec4(world, 1.0);

    // Normals transform by the inverse transpose, which is the cofactor matrix over the determinant; of the
    // latter only the sign matters here, and a singular matrix needs no division.
    vec3 r0 = instance.row0.xyz, r1 = instance.row1.xyz, r2 = instance.row2.xyz;
    float handedness = dot(r0, cross(r1, r2)) < 0.0 ? -1.0 : 1.0;
    vec3 cofactor_normal =
        vec3(dot(cross(r1, r2), normal), dot(cross(r2, r0), normal), dot(cross(r0, r1), normal));
    varyings.position = world;
    // Scaled to the length 1 here so that interpolation weighs all three corners alike.
    float length2 = max(dot(cofactor_normal, cofactor_normal), 1e-30);
    varyings.normal = handedness * cofactor_normal * inversesqrt(length2);
    varyings.tangent = vec4(dot(r0, tangent.xyz), dot(r1, tangent.xyz), dot(r2, tangent.xyz),
                            handedness * tangent.w);
    varyings.colour = vertex_colour;
    varyings.material = material_row(instance);
    varyings.opacity = instance_opacity(instance);
#ifdef OBJECTS
    varyings.object = instance.object;
#endif
#ifdef MOTION
    Instance was = skinned(instances[uint(gl_BaseInstanceARB + gl_InstanceID) + temporal.counts.x]);
    vec3 past_position = local_position;
    morph(was, past_position);
    varyings.past_clip = temporal.past_clip_from_world * vec4(world_from_local(was, past_position), 1.0);
#endif
    Material m = materials[varyings.material];
    varyings.base_colour_uv = transformed_uv(m.base_colour_uv, uv0, uv1);
#if DETAIL >= 1
    varyings.metalness_roughness_uv = transformed_uv(m.metalness_roughness_uv, uv0, uv1);
    varyings.occlusion_uv = transformed_uv(m.occlusion_uv, uv0, uv1);
#endif
#if DETAIL >= 2
    varyings.normal_uv = transformed_uv(m.normal_uv, uv0, uv1);
#endif
#if DETAIL >= 3
    varyings.height_uv = transformed_uv(m.height_uv, uv0, uv1);
#endif
#if EMISSION
    varyings.emissive_uv = transformed_uv(m.emissive_uv, uv0, uv1);
#endif
#if SPECULAR
    varyings.specular_uv = transformed_uv(m.specular_uv, uv0, uv1);
    varyings.specular_colour_uv = transformed_uv(m.specular_colour_uv, uv0, uv1);
#endif
#if TRANSMISSION
    varyings.transmission_uv = transformed_uv(m.transmission_uv, uv0, uv1);
#endif
#if LIGHT_MAP
    varyings.light_map_uv = transformed_uv(m.light_map_uv, uv0, uv1);
#endif
}
