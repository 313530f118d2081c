#include "system/sample_clips.h"

#include "assets/export/gltf.h"
#include "assets/scene.h"

namespace rambla::system_test {
namespace {

using assets::AnimatedPath;
using assets::Interpolation;

/// Two unlit tiles of 2 × 2 m that face +Z, dark and bright, one on a node of its own each.
assets::Scene two_tiles(float dark, float bright) {
    assets::Scene scene;
    assets::Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    for (const glm::vec3& position : mesh.positions)
        mesh.bounds.expand(position);
    for (const float brightness : {dark, bright}) {
        assets::Material& material = scene.materials.emplace_back();
        material.base_colour = {brightness, brightness, brightness, 1.0f};
        material.double_sided = true;
        material.unlit = true;
        const auto index = static_cast<std::uint32_t>(scene.models.size());
        assets::Model& model = scene.models.emplace_back();
        model.parts.push_back({0, index});
        scene.nodes.emplace_back().model = index;
        scene.roots.push_back(index);
    }
    return scene;
}

}  // namespace

void write_clips(const std::filesystem::path& file) {
    assets::Scene scene = two_tiles(0.05f, 0.9f);
    scene.nodes[0].local.scale = {4, 4, 1};
    scene.nodes[1].local.translation_m = {-2, 0, 0.5f};
    assets::Clip& slide = scene.clips.emplace_back();
    slide.name = "slide";
    slide.duration_s = 2.0f;
    slide.channels.push_back({1,
                              AnimatedPath::translation,
                              Interpolation::linear,
                              3,
                              {0, 1, 2},
                              {-2, 0, 0.5f, 2, 0, 0.5f, -2, 0, 0.5f}});
    assets::Clip& spin = scene.clips.emplace_back();
    spin.name = "spin";
    spin.duration_s = 2.0f;
    spin.channels.push_back({1,
                             AnimatedPath::rotation,
                             Interpolation::linear,
                             4,
                             {0, 1, 2},
                             {0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, -1}});
    assets::export_gltf(file, scene);
}

void write_ride(const std::filesystem::path& file) {
    assets::Scene scene = two_tiles(0.0f, 1.0f);
    scene.nodes[0].local.translation_m = {10, 0, 0};
    scene.cameras.push_back({.name = "rider", .vertical_fov_rad = 0.5f, .near_m = 0.1f});
    scene.nodes.resize(4);
    scene.nodes[2].children = {3};
    scene.nodes[3].parent = 2;
    scene.nodes[3].camera = 0;
    scene.nodes[3].local.translation_m = {0, 0, 3};
    scene.roots.push_back(2);
    assets::Clip& ride = scene.clips.emplace_back();
    ride.name = "ride";
    ride.duration_s = 2.0f;
    ride.channels.push_back(
        {2, AnimatedPath::translation, Interpolation::linear, 3, {0, 2}, {0, 0, 0, 10, 0, 0}});
    assets::export_gltf(file, scene);
}

}  // namespace rambla::system_test
