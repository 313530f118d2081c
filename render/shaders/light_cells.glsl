// Lists of local lights, one for each cell of the screen (render/passes/light_bins.h).
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/light_cells.h"

layout(std430, binding = BINDING_LIGHT_CELLS) readonly buffer LightCellBlock {
    LightGrid light_grid;
    uvec2 light_ranges[];
};
layout(std430, binding = BINDING_LIGHT_ENTRIES) readonly buffer LightEntryBlock {
    uint light_entries[];
};

/// First entry and number of entries of a pixel's cell.
/// @param distance_m  of what it shows, along the view
uvec2 lights_of_pixel(uvec2 pixel, float distance_m) {
    uvec2 tile = min(pixel / light_grid.cells.w, light_grid.cells.xy - 1u);
    float slice = floor(log2(max(distance_m, 1e-6)) * light_grid.slicing.x + light_grid.slicing.y);
    uint deep = uint(clamp(slice, 0.0, float(light_grid.cells.z - 1u)));
    return light_ranges[(tile.y * light_grid.cells.x + tile.x) * light_grid.cells.z + deep];
}
