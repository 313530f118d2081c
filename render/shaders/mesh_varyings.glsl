// What the mesh passes hand from vertices to fragments. VARYING is `out` or `in`.
//
// Texture coordinates are transformed per vertex. In fragments, the transform would come from a buffer that
// pixels beside a triangle's edge need not be able to read, and their derivatives, hence their mip levels,
// would be wrong.
VARYING MeshVaryings {
    vec3 position;  ///< camera-relative world, m
    vec3 normal;
    vec4 tangent;
    vec4 colour;
    flat uint material;  ///< row of the material buffer
    flat float opacity;  ///< of the instance, [0, 1]
#ifdef OBJECTS
    flat uint object;
#endif
#ifdef MOTION
    vec4 past_clip;
#endif
    vec2 base_colour_uv;
#if DETAIL >= 1
    vec2 metalness_roughness_uv;
    vec2 occlusion_uv;
#endif
#if DETAIL >= 2
    vec2 normal_uv;
#endif
#if DETAIL >= 3
    vec2 height_uv;
#endif
#if EMISSION
    vec2 emissive_uv;
#endif
#if SPECULAR
    vec2 specular_uv;
    vec2 specular_colour_uv;
#endif
#if TRANSMISSION
    vec2 transmission_uv;
#endif
#if LIGHT_MAP
    vec2 light_map_uv;
#endif
} varyings;
