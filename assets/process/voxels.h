#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "assets/process/surface.h"

namespace rambla::assets {

/// A range of voxels, [min, max).
struct VoxelBox {
    glm::ivec3 min{0};
    glm::ivec3 max{0};

    [[nodiscard]] std::int64_t volume() const {
        const glm::ivec3 size = max - min;
        return std::int64_t{size.x} * size.y * size.z;
    }
};

/// A grid of cubes over a closed surface, in which those wholly inside are marked.
class Interior {
public:
    /// @param surface  closed (is_closed), of finite, positive extents
    /// @param voxels   along its longest axis, ≥ 1
    Interior(const Surface& surface, int voxels);

    [[nodiscard]] glm::ivec3 size() const { return size_; }
    [[nodiscard]] double voxel_m() const { return voxel_m_; }
    /// Lower corner of a voxel, metres.
    [[nodiscard]] glm::dvec3 corner(glm::ivec3 voxel) const { return origin_ + glm::dvec3{voxel} * voxel_m_; }
    [[nodiscard]] bool inside(glm::ivec3 voxel) const { return marks_[index(voxel)] == Mark::inside; }
    [[nodiscard]] bool inside(const VoxelBox& box) const;
    [[nodiscard]] std::int64_t inside_count() const;

    /// The largest box of inside voxels none of which is taken.
    /// @param taken  one entry per voxel, in the order of index()
    [[nodiscard]] VoxelBox largest_box(const std::vector<bool>& taken) const;

    [[nodiscard]] std::size_t index(glm::ivec3 voxel) const {
        return (static_cast<std::size_t>(voxel.z) * static_cast<std::size_t>(size_.y) +
                static_cast<std::size_t>(voxel.y)) *
                   static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(voxel.x);
    }

private:
    enum class Mark : std::uint8_t { unknown, surface, outside, inside };

    void mark_surface(const Surface& surface);
    void mark_regions(const Surface& surface);

    glm::dvec3 origin_{0.0};
    double voxel_m_ = 0.0;
    glm::ivec3 size_{0};
    std::vector<Mark> marks_;
};

}  // namespace rambla::assets
