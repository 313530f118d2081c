// What bloom's passes are told, and what they draw where.
#ifndef RAMBLA_SHARED_BLOOM_H
#define RAMBLA_SHARED_BLOOM_H

#include "render/shaders/shared/light_cells.h"

SHARED_BEGIN

// Indirect draws that head bloom's storage block (std430), each a TileDraw.
SHARED_CONSTANT k_bloom_draw_bright = 0u;   // a quad for each tile in which something is bright
SHARED_CONSTANT k_bloom_draw_visible = 1u;  // a quad for each tile on which glow is seen
SHARED_CONSTANT k_bloom_draw_spread = 2u;   // one triangle over everything, or none where nothing is bright
SHARED_CONSTANT k_bloom_draws = 3u;

// Of a frame (uniform block, std140).
struct BloomFrameConstants {
    vec4 bright;    // luminances at which glow x: begins, y: is proportional, z: which it is counted from; w:
                    // padding
    vec4 shown;     // x: share of the bright light that is spread, y: light that is not seen; zw: padding
    uvec4 tiles;    // x, y: tiles of the picture, z: pixels along the edge of one, w: along that of a bright
                    // texel
    uvec4 size_px;  // xy: of the picture, zw: padding
};

SHARED_CONSTANT k_bloom_tap_pairs = 5u;

// Of one step that spreads light (uniform block, std140). Places are in texels of what is read.
struct BloomStep {
    vec4 share;  // x: of what is read, y: of what it is added to, z: weight of a blur's middle; w: padding
    vec4 axis;   // xy: direction of a blur, or how far off the taps are; zw: padding
    vec4 taps[k_bloom_tap_pairs];  // on each side; x: how far from the middle, y: weight, z: the part of its
                                   // nearer texel, w: how far off the farther one is
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::BloomFrameConstants) == 64);
static_assert(sizeof(rambla::render::shared::BloomStep) == 112);
#endif
#endif
