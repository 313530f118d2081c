#include "assets/trace/placed_scene.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace rambla::assets {
namespace {

constexpr double k_offset_share = 0x1p-32;  // see offset_origin()

bool is_finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double frobenius(const glm::dmat3& m) {
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

double reach_of(const TraceMesh& mesh) {
    double reach = 0.0;
    for (const glm::vec3& position : mesh.positions) {
        const double length = glm::length(glm::dvec3{position});
        if (std::isfinite(length)) reach = std::max(reach, length);
    }
    return reach;
}

void check(const TraceMesh& mesh, std::size_t number) {
    const std::size_t count = mesh.positions.size();
    for (const std::size_t column :
         {mesh.normals.size(), mesh.uv0.size(), mesh.uv1.size(), mesh.colours.size()}) {
        if (column != 0 && column != count)
            throw std::invalid_argument{fmt::format(
                "Traced mesh {} has {} positions, but {} entries in another column", number, count, column)};
    }
    if (mesh.indices.size() % 3 != 0)
        throw std::invalid_argument{fmt::format(
            "Traced mesh {} has {} indices, which is no list of triangles", number, mesh.indices.size())};
    for (const std::uint32_t index : mesh.indices) {
        if (index >= count)
            throw std::invalid_argument{fmt::format(
                "Traced mesh {} has {} positions, but an index refers to number {}", number, count, index)};
    }
}

void check(const TraceScene& scene) {
    const auto refers = [](std::uint32_t index, std::size_t count, const char* what, std::size_t number) {
        if (index >= count)
            throw std::invalid_argument{
                fmt::format("{} {} refers to number {} of {}", what, number, index, count)};
    };
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        check(scene.meshes[i], i);
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        if (scene.textures[i].levels.empty())
            throw std::invalid_argument{fmt::format("Traced texture {} has no levels", i)};
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const std::uint32_t texture = scene.materials[i].texture;
        if (texture != k_none) refers(texture, scene.textures.size(), "The texture of traced material", i);
    }
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const TraceInstance& instance = scene.instances[i];
        refers(instance.mesh, scene.meshes.size(), "The mesh of traced instance", i);
        if (instance.material != k_none)
            refers(instance.material, scene.materials.size(), "The material of traced instance", i);
    }
}

template <class T>
T mixed(std::span<const glm::vec<T::length(), float>> column, std::array<std::uint32_t, 3> corners,
        const PlaneMeeting& meeting) {
    if (column.empty()) return T{0.0};
    return (1.0 - meeting.u - meeting.v) * T{column[corners[0]]} + meeting.u * T{column[corners[1]]} +
           meeting.v * T{column[corners[2]]};
}

glm::dvec2 mixed_uv(const TraceMaterial& material, const TraceMesh& mesh,
                    std::array<std::uint32_t, 3> corners, const PlaneMeeting& meeting) {
    return transformed_uv(
        material.slot, mixed<glm::dvec2>(material.slot.uv_set == 0 ? mesh.uv0 : mesh.uv1, corners, meeting));
}

bool is_inside(const PlaneMeeting& meeting) {
    return meeting.u >= 0.0 && meeting.v >= 0.0 && meeting.u + meeting.v <= 1.0;
}

double largest(glm::dvec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The point of a triangle that is nearest in barycentric coordinates.
PlaneMeeting clamped(const PlacedTriangle& triangle, PlaneMeeting meeting, const TraceRay& ray) {
    const double w = std::max(1.0 - meeting.u - meeting.v, 0.0);
    const double u = std::max(meeting.u, 0.0);
    const double v = std::max(meeting.v, 0.0);
    meeting.u = u / (u + v + w);
    meeting.v = v / (u + v + w);
    const glm::dvec3 point = triangle.corners[0] + meeting.u * (triangle.corners[1] - triangle.corners[0]) +
                             meeting.v * (triangle.corners[2] - triangle.corners[0]);
    meeting.t = glm::dot(point - ray.origin_m, ray.direction) / glm::dot(ray.direction, ray.direction);
    return meeting;
}

}  // namespace

// Möller and Trumbore 1997, with the normal at hand: t from the plane's equation, which is exact where the
// origin lies next to the plane.
std::optional<PlaneMeeting> PlacedTriangle::meet(glm::dvec3 origin_m, glm::dvec3 direction) const {
    const glm::dvec3 side1 = corners[1] - corners[0];
    const glm::dvec3 side2 = corners[2] - corners[0];
    const glm::dvec3 perpendicular = glm::cross(side1, side2);
    const double slope = glm::dot(perpendicular, direction);
    const glm::dvec3 to_corner = corners[0] - origin_m;
    const glm::dvec3 around = glm::cross(to_corner, direction);
    const PlaneMeeting meeting{.t = glm::dot(perpendicular, to_corner) / slope,
                               .u = glm::dot(side2, around) / slope,
                               .v = -glm::dot(side1, around) / slope,
                               .front = glm::dot(normal, direction) < 0.0};
    if (!std::isfinite(meeting.t) || !std::isfinite(meeting.u) || !std::isfinite(meeting.v)) return {};
    return meeting;
}

PlacedScene::PlacedScene(TraceScene scene) : scene_{std::move(scene)} {
    check(scene_);
    std::vector<double> reaches;
    for (const TraceMesh& mesh : scene_.meshes)
        reaches.push_back(reach_of(mesh));
    places_.reserve(scene_.instances.size());
    for (const TraceInstance& instance : scene_.instances)
        places_.push_back(place_of(instance, reaches[instance.mesh]));
}

PlacedScene::Place PlacedScene::place_of(const TraceInstance& instance, double mesh_reach) {
    Place place;
    place.linear =
        glm::dmat3{glm::dvec3{instance.world_from_local[0]}, glm::dvec3{instance.world_from_local[1]},
                   glm::dvec3{instance.world_from_local[2]}};
    place.translation_m = glm::dvec3{instance.world_from_local[3]};
    place.exists = is_finite(place.linear[0]) && is_finite(place.linear[1]) && is_finite(place.linear[2]) &&
                   is_finite(place.translation_m);
    if (!place.exists) return place;
    const glm::dmat3 cofactors{glm::cross(place.linear[1], place.linear[2]),
                               glm::cross(place.linear[2], place.linear[0]),
                               glm::cross(place.linear[0], place.linear[1])};
    const double determinant = glm::dot(place.linear[0], cofactors[0]);
    place.normal_from_local = determinant < 0.0 ? -cofactors : cofactors;
    place.clockwise = instance.clockwise != (determinant < 0.0);
    const double condition = frobenius(place.linear) * frobenius(cofactors) / std::abs(determinant);
    place.condition = std::isfinite(condition) ? condition : std::numeric_limits<double>::infinity();
    place.reach_m = frobenius(place.linear) * mesh_reach;
    return place;
}

std::array<std::uint32_t, 3> PlacedScene::corners_of(std::uint32_t mesh, std::uint32_t triangle) const {
    const auto indices = scene_.meshes[mesh].indices.subspan(std::size_t{3} * triangle, 3);
    return {indices[0], indices[1], indices[2]};
}

glm::dvec3 PlacedScene::placed(std::uint32_t instance, glm::dvec3 local) const {
    const Place& place = places_[instance];
    return place.linear * local + place.translation_m;
}

PlacedTriangle PlacedScene::placed_triangle(std::uint32_t instance, std::uint32_t triangle) const {
    const std::uint32_t number = scene_.instances[instance].mesh;
    const TraceMesh& mesh = scene_.meshes[number];
    const std::array<std::uint32_t, 3> corners = corners_of(number, triangle);
    PlacedTriangle result;
    for (std::size_t i = 0; i < 3; ++i)
        result.corners[i] = placed(instance, glm::dvec3{mesh.positions[corners[i]]});
    result.normal = glm::cross(result.corners[1] - result.corners[0], result.corners[2] - result.corners[0]);
    if (places_[instance].clockwise) result.normal = -result.normal;
    return result;
}

std::optional<PlaneMeeting> PlacedScene::meet(const TraceRay& ray, const RaySpread* spread,
                                              std::uint32_t instance, std::uint32_t triangle) const {
    const TraceInstance& what = scene_.instances[instance];
    if ((what.rays & ray.rays) == 0) return {};
    const PlacedTriangle placed = placed_triangle(instance, triangle);
    const std::optional<PlaneMeeting> on_plane = placed.meet(ray.origin_m, ray.direction);
    if (!on_plane || !(on_plane->t > ray.t_min) || !(on_plane->t < ray.t_max)) return {};
    PlaneMeeting meeting = *on_plane;
    if (!is_inside(meeting)) {
        const double near_m =
            k_near_share * (largest(ray.origin_m + ray.t_min * ray.direction) + places_[instance].reach_m);
        meeting = clamped(placed, meeting, ray);
        if (!((meeting.t - ray.t_min) * glm::length(ray.direction) > near_m) || !(meeting.t < ray.t_max))
            return {};
    }

    const TraceMaterial material =
        what.material == k_none ? TraceMaterial{} : scene_.materials[what.material];
    if (!material.double_sided && ray.faces != TraceFaces::all &&
        meeting.front != (ray.faces == TraceFaces::seen))
        return {};
    if (!material.masked) return meeting;
    const TraceMesh& mesh = scene_.meshes[what.mesh];
    const std::array<std::uint32_t, 3> corners = corners_of(what.mesh, triangle);
    const double texels_per_pixel =
        spread == nullptr ? 0.0 : footprint(material, mesh, corners, placed, ray, *spread);
    if (is_cut_out(material, mesh, corners, meeting, texels_per_pixel)) return {};
    return meeting;
}

bool PlacedScene::is_cut_out(const TraceMaterial& material, const TraceMesh& mesh,
                             std::array<std::uint32_t, 3> corners, const PlaneMeeting& meeting,
                             double texels_per_pixel) const {
    double alpha = material.alpha;
    if (!mesh.colours.empty()) alpha *= mixed<glm::dvec4>(mesh.colours, corners, meeting).w;
    if (material.texture != k_none) {
        alpha *= sampled_alpha(scene_.textures[material.texture], mixed_uv(material, mesh, corners, meeting),
                               texels_per_pixel);
    }
    return alpha < static_cast<double>(material.cutoff);
}

// How far neighbouring pixels lie apart in the texture, if they see the same plane: OpenGL 4.5,
// section 8.14.1.
double PlacedScene::footprint(const TraceMaterial& material, const TraceMesh& mesh,
                              std::array<std::uint32_t, 3> corners, const PlacedTriangle& placed,
                              const TraceRay& ray, const RaySpread& spread) const {
    if (material.texture == k_none) return 0.0;
    const AlphaTexture::Level& finest = scene_.textures[material.texture].levels[0];
    const glm::dvec2 size{finest.width, finest.height};
    const auto texel_of = [&](glm::dvec3 origin_m, glm::dvec3 direction) -> std::optional<glm::dvec2> {
        const std::optional<PlaneMeeting> meeting = placed.meet(origin_m, direction);
        if (!meeting) return {};
        return size * mixed_uv(material, mesh, corners, *meeting);
    };
    const auto here = texel_of(ray.origin_m, ray.direction);
    const auto right = texel_of(ray.origin_m + spread.origin_right_m, ray.direction + spread.direction_right);
    const auto below = texel_of(ray.origin_m + spread.origin_below_m, ray.direction + spread.direction_below);
    if (!here || !right || !below) return std::numeric_limits<double>::infinity();
    return std::max(glm::length(*right - *here), glm::length(*below - *here));
}

TraceHit PlacedScene::hit(const TraceRay& ray, std::uint32_t instance, std::uint32_t triangle,
                          const PlaneMeeting& meeting) const {
    const TraceInstance& what = scene_.instances[instance];
    const TraceMesh& mesh = scene_.meshes[what.mesh];
    const std::array<std::uint32_t, 3> corners = corners_of(what.mesh, triangle);
    const PlacedTriangle placed = placed_triangle(instance, triangle);
    const Place& place = places_[instance];
    double largest_m = 0.0;
    for (const std::uint32_t corner : corners) {
        const glm::dvec3 local = glm::abs(glm::dvec3{mesh.positions[corner]});
        const glm::dvec3 sums = glm::abs(place.linear[0]) * local.x + glm::abs(place.linear[1]) * local.y +
                                glm::abs(place.linear[2]) * local.z + glm::abs(place.translation_m);
        largest_m = std::max({largest_m, sums.x, sums.y, sums.z});
    }
    const glm::dvec3 geometric = glm::normalize(meeting.front ? placed.normal : -placed.normal);
    return {.object = what.object,
            .instance = instance,
            .triangle = triangle,
            .front = meeting.front,
            .barycentric = {meeting.u, meeting.v},
            .t = meeting.t,
            .distance_m = meeting.t * glm::length(ray.direction),
            .position_m = placed.corners[0] + meeting.u * (placed.corners[1] - placed.corners[0]) +
                          meeting.v * (placed.corners[2] - placed.corners[0]),
            .geometric_normal = geometric,
            .shading_normal = shading_normal(mesh, corners, place, meeting, geometric),
            .uv0 = mixed<glm::dvec2>(mesh.uv0, corners, meeting),
            .uv1 = mixed<glm::dvec2>(mesh.uv1, corners, meeting),
            .offset_m = k_offset_share * largest_m};
}

// As render/shaders/mesh.vert.glsl and interpolated_normal() of material.glsl: unit normals of the corners,
// mixed. The side is that of the face, not of the mixed normal.
glm::dvec3 PlacedScene::shading_normal(const TraceMesh& mesh, std::array<std::uint32_t, 3> corners,
                                       const Place& place, const PlaneMeeting& meeting,
                                       glm::dvec3 geometric) const {
    if (mesh.normals.empty()) return geometric;
    const std::array<double, 3> shares{1.0 - meeting.u - meeting.v, meeting.u, meeting.v};
    glm::dvec3 sum{0.0};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 normal = place.normal_from_local * glm::dvec3{mesh.normals[corners[i]]};
        const double length = glm::length(normal);
        if (length > 0.0) sum += shares[i] / length * normal;
    }
    const double length = glm::length(sum);
    if (!(length > 1e-6)) return geometric;
    return (meeting.front ? 1.0 : -1.0) / length * sum;
}

}  // namespace rambla::assets
