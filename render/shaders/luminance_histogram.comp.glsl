// Counts the luminances of a picture, those below δ as δ.
#include "render/shaders/shared/bindings.h"
#include "luminance_bins.glsl"
#include "seen_luminance.glsl"

layout(local_size_x = k_luminance_group, local_size_y = k_luminance_group) in;

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform LuminanceBlock {
    LuminanceConstants constants;
};
layout(std430, binding = BINDING_PASS_STORAGE) buffer HistogramBlock {
    uint bins[];
};

const uint k_invocations = k_luminance_group * k_luminance_group;
shared uint own_bins[k_luminance_bins];

void main() {
    for (uint bin = gl_LocalInvocationIndex; bin < k_luminance_bins; bin += k_invocations)
        own_bins[bin] = 0u;
    barrier();
    ivec2 size = textureSize(scene_colour, 0);
    ivec2 first = ivec2(gl_WorkGroupID.xy * k_luminance_square_px + gl_LocalInvocationID.xy);
    for (int y = 0; y < int(k_luminance_square_px); y += int(k_luminance_group)) {
        for (int x = 0; x < int(k_luminance_square_px); x += int(k_luminance_group)) {
            ivec2 place = first + ivec2(x, y);
            if (any(greaterThanEqual(place, size))) continue;
            float seen = seen_luminance(luminance(texelFetch(scene_colour, place, 0).rgb));
            atomicAdd(own_bins[bin_of(max(seen, constants.delta.x))], 1u);
        }
    }
    barrier();
    for (uint bin = gl_LocalInvocationIndex; bin < k_luminance_bins; bin += k_invocations)
        if (own_bins[bin] > 0u) atomicAdd(bins[bin], own_bins[bin]);
}
