#include "assets/import/gltf.h"

#include "assets/import/gltf_convert.h"
#include "assets/import/gltf_material.h"
#include "assets/import/gltf_mesh.h"
#include "assets/import/gltf_scene.h"
#include "assets/import/gltf_texture.h"

namespace rambla::assets {

Scene import_gltf(const std::filesystem::path& file, const ImportLimits& limits) {
    gltf::Document document = gltf::load_document(file, limits);
    Scene scene;
    gltf::convert(document, scene);
    return scene;
}

namespace gltf {

std::vector<std::uint32_t> convert(Document& document, Scene& scene) {
    scene.name = document.path.stem().string();
    import_materials(document, scene);
    import_meshes(document, scene);
    import_nodes(document, scene);
    return import_textures(document, scene);
}

}  // namespace gltf

}  // namespace rambla::assets
