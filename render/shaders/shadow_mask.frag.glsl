// Cuts masked casters out; depth is all that is written.
#include "scene_buffers.glsl"

layout(binding = UNIT_BASE_COLOUR) uniform sampler2D base_colour_texture;

in vec2 mask_uv;
in float mask_alpha;
flat in uint mask_material;

void main() {
    float alpha = mask_alpha * texture(base_colour_texture, mask_uv).a;
    if (alpha < materials[mask_material].emissive_cutoff.a) discard;
}
