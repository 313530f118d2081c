// Sum of ln(δ + luminance) over a picture, by workgroups that each sum a square of it, and one that adds their
// sums up. Define FIRST: 1 sums squares, 0 adds up.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/luminance.h"
#include "seen_luminance.glsl"

layout(local_size_x = k_luminance_group, local_size_y = k_luminance_group) in;

layout(binding = UNIT_PASS) uniform sampler2D scene_colour;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform LuminanceBlock {
    LuminanceConstants constants;
};
layout(std430, binding = BINDING_PASS_STORAGE) buffer SumBlock {
    vec2 sums[];  ///< of the picture, and then of the squares; x: of the logarithms, y: pixels that are no numbers
};

const uint k_invocations = k_luminance_group * k_luminance_group;
shared vec2 partial[k_invocations];

#if FIRST
vec2 own_sum() {
    ivec2 size = textureSize(scene_colour, 0);
    ivec2 first = ivec2(gl_WorkGroupID.xy * k_luminance_square_px + gl_LocalInvocationID.xy);
    vec2 sum = vec2(0.0);
    for (int y = 0; y < int(k_luminance_square_px); y += int(k_luminance_group)) {
        vec4 row = vec4(1.0);  // whose logarithm is 0
        for (int i = 0; i < 4; ++i) {
            ivec2 place = first + ivec2(i * int(k_luminance_group), y);
            if (any(greaterThanEqual(place, size))) continue;
            float seen = luminance(texelFetch(scene_colour, place, 0).rgb);
            row[i] = seen_luminance(seen) + constants.delta.x;
            sum.y += is_number(seen) ? 0.0 : 1.0;
        }
        sum.x += sum_of_logs(row);
    }
    return sum;
}
#else
vec2 own_sum() {
    vec2 sum = vec2(0.0);
    for (uint i = gl_LocalInvocationIndex; i < constants.groups.z; i += k_invocations)
        sum += sums[1u + i];
    return sum;
}
#endif

void main() {
    uint self = gl_LocalInvocationIndex;
    partial[self] = own_sum();
    barrier();
    for (uint others = k_invocations / 2u; others > 0u; others /= 2u) {
        if (self < others) partial[self] += partial[self + others];
        barrier();
    }
    if (self != 0u) return;
#if FIRST
    sums[1u + gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = partial[0];
#else
    sums[0] = partial[0];
#endif
}
