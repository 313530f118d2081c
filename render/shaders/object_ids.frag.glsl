// Which object a surface belongs to. Defines: OBJECTS, ALPHA_MASK: 1 cuts masked surfaces out; those of material.glsl.
#include "material.glsl"

layout(location = 0) out uint out_object;  ///< 0 is left to pixels without any

void main() {
#if ALPHA_MASK
    if (sample_base_colour(materials[varyings.material]).a < materials[varyings.material].emissive_cutoff.a) discard;
#endif
    out_object = varyings.object + 1u;
}
