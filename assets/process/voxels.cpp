#include "assets/process/voxels.h"

#include <algorithm>
#include <cmath>

#include "assets/process/solid.h"

namespace rambla::assets {

namespace {

template <class Visit>
void for_each_voxel(glm::ivec3 min, glm::ivec3 max, Visit&& visit) {
    for (int z = min.z; z < max.z; ++z)
        for (int y = min.y; y < max.y; ++y)
            for (int x = min.x; x < max.x; ++x)
                visit(glm::ivec3{x, y, z});
}

}  // namespace

Interior::Interior(const Surface& surface, int voxels) {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle)
        for (const glm::dvec3& corner : surface.corners(triangle)) {
            min = glm::min(min, corner);
            max = glm::max(max, corner);
        }
    const glm::dvec3 extents = max - min;
    origin_ = min;
    voxel_m_ = std::max({extents.x, extents.y, extents.z}) / voxels;
    size_ = glm::clamp(glm::ivec3{glm::ceil(extents / voxel_m_)}, 1, voxels);
    marks_.assign(index({0, 0, size_.z}), Mark::unknown);
    mark_surface(surface);
    mark_regions(surface);
}

void Interior::mark_surface(const Surface& surface) {
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        const TriangleCorners t = surface.corners(triangle);
        const glm::dvec3 low = (glm::min(glm::min(t[0], t[1]), t[2]) - origin_) / voxel_m_;
        const glm::dvec3 high = (glm::max(glm::max(t[0], t[1]), t[2]) - origin_) / voxel_m_;
        // One more on each side: neighbours that are only touched are marked too.
        const glm::ivec3 first = glm::clamp(glm::ivec3{glm::floor(low)} - 1, glm::ivec3{0}, size_);
        const glm::ivec3 end = glm::clamp(glm::ivec3{glm::floor(high)} + 2, glm::ivec3{0}, size_);
        for_each_voxel(first, end, [&](glm::ivec3 voxel) {
            Mark& mark = marks_[index(voxel)];
            if (mark != Mark::surface && touches_box(t, corner(voxel), corner(voxel + 1)))
                mark = Mark::surface;
        });
    }
}

/// Voxels that no triangle touches are in or out as a whole, and so are all that can be reached from one
/// without crossing the surface: one winding number decides for a region. Those that reach the grid's rim are
/// outside.
void Interior::mark_regions(const Surface& surface) {
    constexpr std::size_t k_smallest_region = 8;  // no box worth having fits into less
    std::vector<glm::ivec3> region;
    for_each_voxel(glm::ivec3{0}, size_, [&](glm::ivec3 start) {
        if (marks_[index(start)] != Mark::unknown) return;
        bool at_rim = false;
        region.assign(1, start);
        marks_[index(start)] = Mark::outside;
        for (std::size_t i = 0; i < region.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                for (const int step : {-1, 1}) {
                    glm::ivec3 next = region[i];
                    next[axis] += step;
                    const bool beyond = next[axis] < 0 || next[axis] >= size_[axis];
                    at_rim = at_rim || beyond;
                    if (beyond || marks_[index(next)] != Mark::unknown) continue;
                    marks_[index(next)] = Mark::outside;
                    region.push_back(next);
                }
        if (at_rim || region.size() < k_smallest_region) return;
        if (winding_number(surface, corner(start) + 0.5 * voxel_m_) < 0.5) return;
        for (const glm::ivec3 voxel : region)
            marks_[index(voxel)] = Mark::inside;
    });
}

bool Interior::inside(const VoxelBox& box) const {
    bool all = true;
    for_each_voxel(box.min, box.max, [&](glm::ivec3 voxel) { all = all && inside(voxel); });
    return all;
}

std::int64_t Interior::inside_count() const {
    return std::count(marks_.begin(), marks_.end(), Mark::inside);
}

/// For every range of layers, the largest rectangle in the columns that are free through all of them: per row
/// the heights of free columns that end there, and per height how far it reaches to both sides.
VoxelBox Interior::largest_box(const std::vector<bool>& taken) const {
    VoxelBox best;
    std::vector<bool> free(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    std::vector<int> heights(static_cast<std::size_t>(size_.x));
    for (int z0 = 0; z0 < size_.z; ++z0) {
        free.assign(free.size(), true);
        for (int z1 = z0; z1 < size_.z; ++z1) {
            heights.assign(heights.size(), 0);
            for (int y = 0; y < size_.y; ++y) {
                for (int x = 0; x < size_.x; ++x) {
                    const std::size_t column = index({x, y, 0});
                    const std::size_t voxel = index({x, y, z1});
                    if (marks_[voxel] != Mark::inside || taken[voxel]) free[column] = false;
                    int& height = heights[static_cast<std::size_t>(x)];
                    height = free[column] ? height + 1 : 0;
                }
                for (int x0 = 0; x0 < size_.x; ++x0) {
                    int lowest = size_.y;
                    for (int x1 = x0; x1 < size_.x; ++x1) {
                        lowest = std::min(lowest, heights[static_cast<std::size_t>(x1)]);
                        if (lowest == 0) break;
                        const VoxelBox box{{x0, y + 1 - lowest, z0}, {x1 + 1, y + 1, z1 + 1}};
                        if (box.volume() > best.volume()) best = box;
                    }
                }
            }
        }
    }
    return best;
}

}  // namespace rambla::assets
