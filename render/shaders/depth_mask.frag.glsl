// Cuts masked surfaces out; depth is all that is written. Defines: those of material.glsl.
#include "material.glsl"

void main() {
    if (sample_base_colour(materials[varyings.material]).a < materials[varyings.material].emissive_cutoff.a) discard;
}
