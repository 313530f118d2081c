// A step of exposure towards what the picture's luminances call for. Defines: SUMS_IN_BUFFER: where they are;
// ESTIMATE: 1 finds scale and white of extended Reinhard from them; ADAPT: 1 follows them in time.
#include "render/shaders/shared/adapted_exposure.h"
#include "render/shaders/shared/bindings.h"
#include "exposure.glsl"
#include "luminance_bins.glsl"

layout(local_size_x = 1) in;

layout(std140, binding = BINDING_PASS_UNIFORMS) uniform StepBlock {
    ExposureStep now;
};
layout(std430, binding = BINDING_PASS_STORAGE) buffer ExposureBlock {
    AdaptedExposure exposure;
};
#if SUMS_IN_BUFFER
layout(std430, binding = BINDING_PASS_STORAGE + 1) readonly buffer SumBlock {
    vec2 sums[];
};
#else
layout(binding = UNIT_PASS) uniform sampler2D sums;  ///< in the one texel of its last level
#endif
#if ESTIMATE
layout(std430, binding = BINDING_PASS_STORAGE + 2) readonly buffer HistogramBlock {
    uint bins[];
};
#endif

vec2 picture_sums() {
#if SUMS_IN_BUFFER
    return sums[0];
#else
    return texelFetch(sums, ivec2(0), textureQueryLevels(sums) - 1).xy;
#endif
}

#if ESTIMATE
/// Luminances that 1 % of the pixels do not exceed, and 99 %.
vec2 percentiles() {
    uint all = 0u;
    for (uint bin = 0u; bin < k_luminance_bins; ++bin)
        all += bins[bin];
    uint low_rank = (all - 1u + 50u) / 100u;  // rounded
    uint high_rank = all - 1u - low_rank;
    uint passed = 0u;
    uint low = 0u;
    uint high = 0u;
    for (uint bin = 0u; bin < k_luminance_bins; ++bin) {
        if (passed <= low_rank) low = bin;
        if (passed <= high_rank) high = bin;
        passed += bins[bin];
    }
    return exp2(vec2(log2_of_bin(low), log2_of_bin(high)));
}
#endif

void main() {
    vec2 sum = picture_sums();
    float average = exp(sum.x / now.bounds.z);
    exposure.seen = vec4(average, sum.y * now.bounds.w, 0.0, 0.0);
    exposure.shown = vec4(1.0, now.curve.x, 0.0, 0.0);
#if ADAPT
    double target = double(target_ev(average, now.follows.z, now.follows.w, now.bounds.x));
    double share = double(target > exposure.ev ? now.follows.x : now.follows.y);
    exposure.ev = followed_ev(exposure.ev, target, share);
    exposure.shown.x = exp2(float(exposure.ev));
#else
    exposure.ev = 0.0;
#endif
#if ESTIMATE
    exposure.seen.zw = max(percentiles(), vec2(now.bounds.y));
    vec2 curve = estimated_curve(average, exposure.seen.z, exposure.seen.w);
    // It says what the average becomes: an exposure would cancel out of it.
    exposure.shown.xy = vec2(curve.x / average, curve.y);
#endif
}
