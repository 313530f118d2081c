// Where shaders find what. GLSL needs literals in layout qualifiers, hence macros.
#ifndef RAMBLA_SHARED_BINDINGS_H
#define RAMBLA_SHARED_BINDINGS_H

// Uniform blocks.
#define BINDING_FRAME_UNIFORMS 0  // shared/frame_uniforms.h, bound for the whole frame
#define BINDING_PASS_UNIFORMS 1   // each pass's own block
#define BINDING_EXPOSURE 2        // shared/adapted_exposure.h, where a pass wants what exposure adapted to

// Shader storage blocks.
#define BINDING_INSTANCES 0      // shared/instance.h, bound for the whole frame
#define BINDING_MATERIALS 1      // shared/material.h, bound for the whole frame
#define BINDING_LIGHTS 2         // shared/light.h, bound for the whole frame
#define BINDING_JOINTS 3         // shared/deformation.h, bound for the whole frame
#define BINDING_MORPH_TERMS 4    // shared/deformation.h, bound for the whole frame
#define BINDING_MORPHS 5         // render/scene_morphs.h, bound for the whole frame
#define BINDING_LIGHT_CELLS 6    // shared/light_cells.h, bound for the whole frame where anything reads it
#define BINDING_LIGHT_ENTRIES 7  // rows of the lights, cell by cell; as above
#define BINDING_PASS_STORAGE 8   // first of each pass's own

// Texture units. Material textures are bound by render/draw.h, the others by each pass.
#define UNIT_BASE_COLOUR 0
#define UNIT_METALNESS_ROUGHNESS 1
#define UNIT_NORMAL 2
#define UNIT_OCCLUSION 3
#define UNIT_EMISSIVE 4
#define UNIT_SPECULAR 5
#define UNIT_SPECULAR_COLOUR 6
#define UNIT_HEIGHT 7
#define UNIT_TRANSMISSION 8
#define UNIT_LIGHT_MAP 9
#define UNIT_BESIDE_MATERIALS 10  // first of a pass's own, where it draws materials
#define UNIT_PASS 0               // the same, where it draws none: OpenGL promises 16 units

// Vertex attributes of every mesh; missing columns hold neutral values.
#define ATTRIBUTE_POSITION 0  // vec3, metres
#define ATTRIBUTE_NORMAL 1    // vec3
#define ATTRIBUTE_TANGENT 2   // vec4, w: handedness; all zero: the mesh has no tangents
#define ATTRIBUTE_UV0 3       // vec2
#define ATTRIBUTE_UV1 4       // vec2
#define ATTRIBUTE_COLOUR 5    // vec4, linear
// Of skinned meshes only.
#define ATTRIBUTE_JOINTS 6   // uvec4
#define ATTRIBUTE_WEIGHTS 7  // vec4, of sum 1

#endif
