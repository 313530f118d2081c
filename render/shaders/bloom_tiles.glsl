// Tiles of the screen by what bloom has to do there. BLOOM_ACCESS: readonly unless a shader defines it.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/bloom.h"

#ifndef BLOOM_ACCESS
#define BLOOM_ACCESS readonly
#endif

layout(std140, binding = BINDING_PASS_UNIFORMS) uniform BloomFrameBlock {
    BloomFrameConstants bloom;
};
layout(std430, binding = BINDING_PASS_STORAGE) BLOOM_ACCESS buffer BloomTileBlock {
    TileDraw bloom_draws[k_bloom_draws];
    uint bloom_tiles[];  ///< those where something is bright; after room for all, those where glow is seen
};
