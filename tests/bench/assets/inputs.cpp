#include "bench/assets/inputs.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "assets/export/gltf.h"
#include "assets/generate/places.h"

namespace rambla::bench {
namespace {

namespace fs = std::filesystem;

/// A wavy square of quads with everything that a static mesh of a scene usually has.
assets::Mesh wavy_square(std::uint32_t quads) {
    assets::Mesh mesh;
    const std::uint32_t side = quads + 1;
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t x = 0; x < side; ++x) {
            const glm::vec2 place{static_cast<float>(x), static_cast<float>(z)};
            mesh.positions.push_back({place.x, std::sin(place.x * 0.1f), place.y});
            mesh.normals.push_back(glm::normalize(glm::vec3{-0.1f * std::cos(place.x * 0.1f), 1.0f, 0.0f}));
            mesh.uv0.push_back(place / static_cast<float>(quads));
            mesh.bounds.expand(mesh.positions.back());
        }
    for (std::uint32_t z = 0; z < quads; ++z)
        for (std::uint32_t x = 0; x < quads; ++x) {
            const std::uint32_t a = z * side + x;
            mesh.indices.insert(mesh.indices.end(), {a, a + side, a + 1, a + 1, a + side, a + side + 1});
        }
    return mesh;
}

fs::path write_mesh(const fs::path& folder) {
    assets::Scene scene;
    scene.meshes = {wavy_square(1000)};
    scene.models = {{.name = "square", .parts = {{0, assets::k_none}}}};
    scene.nodes.resize(1);
    scene.nodes[0].model = 0;
    scene.roots = {0};
    const fs::path file = folder / "mesh.glb";
    assets::export_gltf(file, scene);
    return file;
}

fs::path write_city(const fs::path& folder) {
    assets::Scene scene = std::move(assets::generate_place("city:blocks=2x2", 1).scene);
    for (assets::Material& material : scene.materials)
        assets::for_each_texture_slot(material, [](assets::TextureSlot& slot) { slot = {}; });
    scene.textures.clear();
    scene.images.clear();
    const fs::path file = folder / "city.glb";
    assets::export_gltf(file, scene);
    return file;
}

}  // namespace

std::vector<Input> inputs(const fs::path& folder) {
    std::vector<Input> found{{k_generated_mesh, write_mesh(folder)}, {k_generated_city, write_city(folder)}};
    const fs::path corpus = RAMBLA_GLTF_DIR;
    const Input samples[]{
        {k_tokyo, corpus / "scenes/LittlestTokyo/LittlestTokyo.gltf"},
        {k_helmet, corpus / "models/FlightHelmet/glTF-512px/FlightHelmet.gltf"},
        {k_knight, corpus / "characters/KayKit-Adventurers/Knight.glb"},
        {k_transmission, corpus / "models/TransmissionTest/glTF-Binary/TransmissionTest.glb"},
        {k_garage, corpus / "scenes/garage/garage.gltf"},
        {k_morphs, corpus / "models/MorphStressTest/glTF-Binary/MorphStressTest.glb"}};
    for (const Input& sample : samples) {
        if (!corpus.empty() && fs::exists(sample.file))
            found.push_back(sample);
        else
            std::fprintf(stderr, "NOT MEASURED: %s (RAMBLA_GLTF_DIR names no folder that holds it)\n",
                         std::string{sample.operation}.c_str());
    }
    return found;
}

}  // namespace rambla::bench
