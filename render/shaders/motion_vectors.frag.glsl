// By how many pixels a surface has moved since the picture before. Defines: MOTION, ALPHA_MASK: 1 cuts masked surfaces out;
// those of material.glsl.
#include "material.glsl"
#include "motion.glsl"

layout(location = 0) out vec2 out_motion;

void main() {
#if ALPHA_MASK
    if (sample_base_colour(materials[varyings.material]).a < materials[varyings.material].emissive_cutoff.a) discard;
#endif
    out_motion = motion_px(gl_FragCoord.xy, varyings.past_clip);
}
