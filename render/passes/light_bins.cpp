#include "render/passes/light_bins.h"

#include <algorithm>
#include <cmath>

namespace rambla::render {
namespace {

/// Slice 0 ends there: nearer cells would be of no use, pixels in them are few.
constexpr float k_first_slice_end_m = 1.0f;
/// From here on, all is one slice: beyond a street's end lamps are few and small.
constexpr float k_last_slice_begin_m = 256.0f;
/// The shader's logarithm may be off by some units in the last place, and slices are found from it: lights
/// that end that close to a slice belong to it too.
constexpr float k_slice_slack = 0.01f;

/// The cells that a light touches; ends are included.
struct CellBox {
    glm::uvec3 first{0};
    glm::uvec3 last{0};
};

std::uint32_t tile_of(float ndc, std::uint32_t size_px, std::uint32_t tile_px, std::uint32_t tiles) {
    const float pixel = (0.5f * ndc + 0.5f) * static_cast<float>(size_px);
    const auto tile = static_cast<std::int64_t>(std::floor(pixel / static_cast<float>(tile_px)));
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(tile, 0, std::int64_t{tiles} - 1));
}

std::uint32_t slice_of(float distance_m, const shared::LightGrid& grid, float slack) {
    if (!(distance_m > 0.0f)) return 0;
    const float slice = std::floor(std::log2(distance_m) * grid.slicing.x + grid.slicing.y + slack);
    return static_cast<std::uint32_t>(std::clamp(slice, 0.0f, static_cast<float>(grid.cells.z - 1)));
}

CellBox cells_of(const ScreenRectangle& bounds, const shared::LightGrid& grid, glm::uvec2 size_px) {
    const std::uint32_t tile_px = grid.cells.w;
    return {.first = {tile_of(bounds.min.x, size_px.x, tile_px, grid.cells.x),
                      tile_of(bounds.min.y, size_px.y, tile_px, grid.cells.y),
                      slice_of(bounds.nearest_m, grid, -k_slice_slack)},
            .last = {tile_of(bounds.max.x, size_px.x, tile_px, grid.cells.x),
                     tile_of(bounds.max.y, size_px.y, tile_px, grid.cells.y),
                     slice_of(bounds.farthest_m, grid, k_slice_slack)}};
}

shared::LightGrid make_grid(glm::uvec2 size_px, std::uint32_t tile_px, std::uint32_t slices) {
    // slice(k_first_slice_end_m) = 1, slice(k_last_slice_begin_m) = slices − 1.
    const float doublings = std::log2(k_last_slice_begin_m / k_first_slice_end_m);
    const float per_doubling = slices > 2 ? static_cast<float>(slices - 2) / doublings : 1.0f;
    return {
        .cells = {(size_px.x + tile_px - 1) / tile_px, (size_px.y + tile_px - 1) / tile_px, slices, tile_px},
        .slicing = {per_doubling, 1.0f - std::log2(k_first_slice_end_m) * per_doubling, 0.0f, 0.0f}};
}

std::uint64_t entries_of(std::span<const BoundedLight> lights, const shared::LightGrid& grid,
                         glm::uvec2 size_px) {
    std::uint64_t count = 0;
    for (const BoundedLight& light : lights) {
        const CellBox box = cells_of(light.bounds, grid, size_px);
        const glm::uvec3 cells = box.last - box.first + 1u;
        count += std::uint64_t{cells.x} * cells.y * cells.z;
    }
    return count;
}

/// The grid that is asked for, or one of larger cells, where its lists would be too long.
shared::LightGrid affordable_grid(std::span<const BoundedLight> lights, glm::uvec2 size_px,
                                  std::uint32_t tile_px, std::uint32_t slices) {
    shared::LightGrid grid = make_grid(size_px, tile_px, slices);
    const auto cells = [&] {
        return std::uint64_t{grid.cells.x} * grid.cells.y * grid.cells.z;
    };
    const auto is_dear = [&] {
        return cells() > k_most_light_cells || entries_of(lights, grid, size_px) > k_most_light_entries;
    };
    while (cells() > 1 && is_dear()) {
        const bool deep = grid.cells.z > 1u;
        grid = make_grid(size_px, deep ? grid.cells.w : 2u * grid.cells.w, deep ? grid.cells.z / 2u : 1u);
    }
    return grid;
}

template <class Visit>
void for_each_cell(const CellBox& box, const shared::LightGrid& grid, Visit&& visit) {
    for (std::uint32_t y = box.first.y; y <= box.last.y; ++y) {
        for (std::uint32_t x = box.first.x; x <= box.last.x; ++x) {
            const std::size_t tile = std::size_t{y} * grid.cells.x + x;
            for (std::uint32_t slice = box.first.z; slice <= box.last.z; ++slice)
                visit(tile * grid.cells.z + slice);
        }
    }
}

}  // namespace

void bound_lights(const systems::FrameView& view, std::span<const systems::FrameLight> lights,
                  std::vector<BoundedLight>& found) {
    found.clear();
    for (std::uint32_t light = 0; light < lights.size(); ++light) {
        const glm::vec3 place = lights[light].position_m;
        if (!std::isfinite(place.x + place.y + place.z) || !(lights[light].radius_m > 0.0f)) continue;
        const auto bounds =
            sphere_rectangle(view, place, std::min(lights[light].radius_m, k_farthest_light_m));
        if (bounds) found.push_back({light, *bounds});
    }
}

const LightBins& LightBinner::bin(glm::uvec2 size_px, std::span<const BoundedLight> lights,
                                  std::uint32_t tile_px, std::uint32_t slices) {
    bins_.grid = affordable_grid(lights, size_px, tile_px, slices);
    const shared::LightGrid& grid = bins_.grid;
    bins_.ranges.assign(std::size_t{grid.cells.x} * grid.cells.y * grid.cells.z, glm::uvec2{0});
    for (const BoundedLight& light : lights) {
        for_each_cell(cells_of(light.bounds, grid, size_px), grid,
                      [&](std::size_t cell) { ++bins_.ranges[cell].y; });
    }
    std::uint32_t first = 0;
    for (glm::uvec2& range : bins_.ranges) {
        range.x = first;
        first += range.y;
        range.y = 0;
    }
    bins_.entries.resize(first);
    for (const BoundedLight& light : lights) {
        for_each_cell(cells_of(light.bounds, grid, size_px), grid, [&](std::size_t cell) {
            glm::uvec2& range = bins_.ranges[cell];
            bins_.entries[range.x + range.y++] = light.light;
        });
    }
    return bins_;
}

}  // namespace rambla::render
