#include "assets/import/gltf.h"

#include "assets/import/gltf_document.h"
#include "assets/import/gltf_material.h"
#include "assets/import/gltf_mesh.h"
#include "assets/import/gltf_scene.h"
#include "assets/import/gltf_texture.h"

namespace rambla::assets {

Scene import_gltf(const std::filesystem::path& file, const ImportLimits& limits) {
    gltf::Document document = gltf::load_document(file, limits);
    Scene scene;
    scene.name = file.stem().string();
    gltf::import_materials(document, scene);
    gltf::import_meshes(document, scene);
    gltf::import_nodes(document, scene);
    gltf::import_textures(document, scene);
    return scene;
}

}  // namespace rambla::assets
