// The screen in cells, each with a list of the local lights that can reach it: tiles, or tiles times slices
// of depth.
#ifndef RAMBLA_SHARED_LIGHT_CELLS_H
#define RAMBLA_SHARED_LIGHT_CELLS_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN

// How cells divide the screen (heads the storage block of their ranges, std430).
struct LightGrid {
    uvec4 cells;   // x, y: tiles, z: slices of each, w: pixels along a tile's edge
    vec4 slicing;  // slice of a point z metres before the eye: floor(log2(z)·x + y), held to the slices there
                   // are
};

// What a light reaches of the depths (storage block, std430), metres before the eye.
struct LightDepths {
    float nearest_m;
    float farthest_m;
};

// Tiles that call for the same work, one class after the other. Each class is one indirect draw.
SHARED_CONSTANT k_tile_class_sky_lit = 0u;   // geometry, and no local light
SHARED_CONSTANT k_tile_class_lamp_lit = 1u;  // geometry that local lights reach
SHARED_CONSTANT k_tile_classes = 2u;

// As glDrawArraysIndirect takes it.
struct TileDraw {
    uint vertex_count;
    uint tile_count;
    uint first_vertex;
    uint base_instance;
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::LightGrid) == 32);
static_assert(sizeof(rambla::render::shared::LightDepths) == 8);
static_assert(sizeof(rambla::render::shared::TileDraw) == 16);
#endif
#endif
