// What the steps share that spread light.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/bloom.h"

layout(binding = UNIT_PASS) uniform sampler2D source;
layout(binding = UNIT_PASS + 1) uniform sampler2D other;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform BloomStepBlock {
    BloomStep bloom_step;
};

layout(location = 0) out vec4 out_light;

/// What a sampler that filters and clamps finds. @param texel  place in texels: the first one's middle is at 0.5
vec3 light_at(sampler2D light, vec2 texel) {
    return texture(light, texel / vec2(textureSize(light, 0))).rgb;
}
