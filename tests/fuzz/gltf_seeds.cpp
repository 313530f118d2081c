#include "fuzz/gltf_seeds.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include "assets/export/gltf.h"
#include "assets/generate/places.h"
#include "assets/import/gltf_container.h"
#include "fuzz/scratch.h"
#include "support/sample_scenes.h"

namespace rambla::fuzz {

namespace {

GltfSeed exported(const std::string& name, const assets::Scene& scene) {
    const std::filesystem::path file = scratch_folder() / "seed.glb";
    assets::export_gltf(file, scene);
    const std::vector<std::byte> glb = read_scratch(file);
    const auto* const first = reinterpret_cast<const unsigned char*>(glb.data());
    const auto parts = assets::gltf::split_container("seed.glb", {first, glb.size()});
    return {name, std::string{parts.json},
            std::string{reinterpret_cast<const char*>(parts.binary.data()), parts.binary.size()}};
}

/// The smallest mesh of the city, alone.
assets::Scene generated_piece() {
    const assets::Scene city = assets::generate_place("city:blocks=1x1,walkers=1,cars=1", 1).scene;
    assets::Scene piece;
    piece.meshes = {*std::min_element(
        city.meshes.begin(), city.meshes.end(),
        [](const auto& a, const auto& b) { return a.positions.size() < b.positions.size(); })};
    piece.models = {{.name = "piece", .parts = {{0, assets::k_none}}}};
    piece.nodes.resize(1);
    piece.nodes[0].model = 0;
    piece.roots = {0};
    return piece;
}

template <class T>
std::string bytes_of(std::initializer_list<T> values) {
    return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(T)};
}

/// Accessors that are sparse, interleaved, normalised, of small types, and without a buffer view.
GltfSeed accessors_of_all_kinds() {
    const std::string buffer = bytes_of<std::int16_t>({0, 0, 0, 0, 9, 0, 0, 0, 0, 9, 0, 0}) +
                               bytes_of<std::uint8_t>({0, 1, 2, 0, 127, 255, 64, 255}) +
                               bytes_of<std::uint16_t>({1, 0}) + bytes_of<float>({1, 2, 3});
    return {"accessors", R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],
"extensionsRequired":["KHR_mesh_quantization"],"buffers":[{"byteLength":48}],
"bufferViews":[{"buffer":0,"byteLength":24,"byteStride":8},{"buffer":0,"byteOffset":24,"byteLength":8},
{"buffer":0,"byteOffset":32,"byteLength":4},{"buffer":0,"byteOffset":36,"byteLength":12}],
"accessors":[{"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3","min":[0,0,0],"max":[9,9,0]},
{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"},
{"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,"componentType":5123},
"values":{"bufferView":3}}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":5},{"attributes":{"POSITION":2},"mode":6},
{"attributes":{"POSITION":2},"mode":2},{"attributes":{"POSITION":0},"mode":3},{"attributes":{"POSITION":2},"mode":0}]}],
"nodes":[{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,4,5,6,1]}],"scenes":[{"nodes":[0]}]})",
            buffer};
}

/// EXT_mesh_gpu_instancing, two sets of joints, and a second scene.
GltfSeed instances_and_influences() {
    const std::string buffer = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                               bytes_of<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}) +
                               bytes_of<std::uint8_t>({128, 127, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0});
    return {"instances", R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_mesh_gpu_instancing"],
"buffers":[{"byteLength":60}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12},
{"buffer":0,"byteOffset":48,"byteLength":12}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5121,"count":3,"type":"VEC4"},
{"bufferView":2,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,"JOINTS_1":1,"WEIGHTS_1":2}}]}],
"skins":[{"joints":[1,2]}],
"nodes":[{"mesh":0,"skin":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0,"SCALE":0}}}},
{"children":[2]},{}],"scene":1,"scenes":[{},{"nodes":[0,1]}]})",
            buffer};
}

}  // namespace

std::vector<unsigned char> glb_of(const GltfSeed& seed) {
    const auto* const first = reinterpret_cast<const unsigned char*>(seed.buffer.data());
    return assets::gltf::join_container(seed.json, {first, seed.buffer.size()});
}

std::vector<GltfSeed> gltf_seeds() {
    return {exported("standing", assets::test::standing_scene()),
            exported("moving", assets::test::moving_scene()), exported("generated", generated_piece()),
            accessors_of_all_kinds(), instances_and_influences()};
}

}  // namespace rambla::fuzz
