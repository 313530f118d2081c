#include "assets/process/occluders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "assets/process/bounds.h"
#include "assets/process/columns.h"
#include "assets/process/deviation.h"
#include "assets/process/solid.h"
#include "assets/process/voxels.h"

namespace rambla::assets {

namespace {

struct DoubleBox {
    glm::dvec3 min{0.0};
    glm::dvec3 max{0.0};
};

/// Moves each face outwards by whole voxels, over taken ones too: boxes that overlap leave no cracks between
/// them.
VoxelBox extended(VoxelBox box, const Interior& interior) {
    for (int axis = 0; axis < 3; ++axis) {
        VoxelBox slab = box;
        for (slab.max[axis] = box.min[axis]; box.min[axis] > 0; --box.min[axis], --slab.max[axis]) {
            slab.min[axis] = box.min[axis] - 1;
            if (!interior.inside(slab)) break;
        }
        slab = box;
        for (slab.min[axis] = box.max[axis]; box.max[axis] < interior.size()[axis];
             ++box.max[axis], ++slab.min[axis]) {
            slab.max[axis] = box.max[axis] + 1;
            if (!interior.inside(slab)) break;
        }
    }
    return box;
}

/// Moves each face outwards, by less than a voxel, until the box nearly touches the surface. A box that
/// touches no triangle, grown from one inside, is inside.
DoubleBox fitted(DoubleBox box, const Surface& surface, double voxel_m) {
    std::vector<TriangleCorners> near;
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle)
        if (touches_box(surface.corners(triangle), box.min - voxel_m, box.max + voxel_m))
            near.push_back(surface.corners(triangle));
    const auto is_free = [&](const DoubleBox& candidate) {
        return std::none_of(near.begin(), near.end(), [&](const TriangleCorners& triangle) {
            return touches_box(triangle, candidate.min, candidate.max);
        });
    };
    constexpr int k_halvings = 12;  // to 1/4096 of a voxel
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            double reach = 0.0;
            double step = voxel_m;
            for (int i = 0; i < k_halvings; ++i) {
                step *= 0.5;
                DoubleBox candidate = box;
                (side < 0.0 ? candidate.min : candidate.max)[axis] += side * (reach + step);
                if (is_free(candidate)) reach += step;
            }
            (side < 0.0 ? box.min : box.max)[axis] += side * reach;
        }
    return box;
}

/// A float box inside: one step covers rounding, which is at most half a step.
Bounds rounded_inwards(const DoubleBox& box) {
    Bounds out{glm::vec3{box.min}, glm::vec3{box.max}};
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        out.min[axis] = std::nextafter(out.min[axis], k_infinity);
        out.max[axis] = std::nextafter(out.max[axis], -k_infinity);
    }
    return out;
}

/// Volume of the union: that of all cells between the boxes' sides that lie in some box.
double volume_of(const std::vector<Bounds>& boxes) {
    std::array<std::vector<float>, 3> sides;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float>& places = sides[static_cast<std::size_t>(axis)];
        for (const Bounds& box : boxes)
            places.insert(places.end(), {box.min[axis], box.max[axis]});
        std::sort(places.begin(), places.end());
    }
    const auto in_some_box = [&](glm::vec3 min, glm::vec3 max) {
        return std::any_of(boxes.begin(), boxes.end(), [&](const Bounds& box) {
            return glm::all(glm::lessThanEqual(box.min, min)) &&
                   glm::all(glm::greaterThanEqual(box.max, max));
        });
    };
    double volume = 0.0;
    for (std::size_t x = 1; x < sides[0].size(); ++x)
        for (std::size_t y = 1; y < sides[1].size(); ++y)
            for (std::size_t z = 1; z < sides[2].size(); ++z) {
                const glm::vec3 min{sides[0][x - 1], sides[1][y - 1], sides[2][z - 1]};
                const glm::vec3 max{sides[0][x], sides[1][y], sides[2][z]};
                const glm::dvec3 size = glm::dvec3{max} - glm::dvec3{min};
                if (in_some_box(min, max)) volume += size.x * size.y * size.z;
            }
    return volume;
}

}  // namespace

OccluderProxy occluder_proxy(const Mesh& mesh, const OccluderParameters& parameters) {
    if (mesh.topology != Topology::triangles || !all_finite(mesh.positions)) return {};
    const glm::vec3 half = bounds_of(mesh.positions).half_extents();
    if (2.0f * std::max({half.x, half.y, half.z}) < parameters.least_size_m) return {};
    if (!is_closed(mesh.positions, mesh.indices)) return {};
    const Surface surface{mesh.positions, mesh.indices};
    const double volume = enclosed_volume(surface);
    if (!(volume > 0.0)) return {};

    const Interior interior{surface, parameters.voxels};
    const double voxel_volume = interior.voxel_m() * interior.voxel_m() * interior.voxel_m();
    std::vector<bool> taken(interior.index({0, 0, interior.size().z}));
    OccluderProxy proxy;
    for (int i = 0; i < parameters.boxes; ++i) {
        const VoxelBox largest = interior.largest_box(taken);
        if (static_cast<double>(largest.volume()) * voxel_volume < double{parameters.smallest} * volume)
            break;
        const VoxelBox box = extended(largest, interior);
        for (int z = box.min.z; z < box.max.z; ++z)
            for (int y = box.min.y; y < box.max.y; ++y)
                for (int x = box.min.x; x < box.max.x; ++x)
                    taken[interior.index({x, y, z})] = true;
        proxy.boxes.push_back(rounded_inwards(
            fitted({interior.corner(box.min), interior.corner(box.max)}, surface, interior.voxel_m())));
    }
    if (proxy.boxes.empty()) return {};
    constexpr double k_gap_resolution = 1e-3;  // of a voxel
    proxy.volume_share = static_cast<float>(std::min(1.0, volume_of(proxy.boxes) / volume));
    const double resolution_m = k_gap_resolution * interior.voxel_m();
    proxy.gap_m =
        std::nextafter(static_cast<float>(one_sided_deviation(surface, proxy.boxes, resolution_m).at_most_m),
                       std::numeric_limits<float>::infinity());
    return proxy;
}

}  // namespace rambla::assets
