#include "assets/import/gltf.h"

#include "assets/import/gltf_clip.h"
#include "assets/import/gltf_convert.h"
#include "assets/import/gltf_emitter.h"
#include "assets/import/gltf_instances.h"
#include "assets/import/gltf_material.h"
#include "assets/import/gltf_scene.h"
#include "assets/import/gltf_skin.h"
#include "assets/import/gltf_texture.h"

namespace rambla::assets {

Scene import_gltf(const std::filesystem::path& file, const ImportLimits& limits) {
    gltf::Document document = gltf::load_document(file, limits);
    Scene scene;
    gltf::convert(document, scene);
    return scene;
}

namespace gltf {

std::vector<MissingColumns> convert_data(Document& document, Scene& scene) {
    scene.name = document.path.stem().string();
    import_materials(document, scene);
    import_emitters(document, scene);
    std::vector<MissingColumns> missing = import_meshes(document, scene);
    import_nodes(document, scene);
    spend_particles(document, scene);
    import_skins(document, scene);
    import_clips(document, scene);
    import_instances(document, scene);
    return missing;
}

std::vector<std::uint32_t> convert(Document& document, Scene& scene) {
    complete_meshes(scene, convert_data(document, scene));
    return import_textures(document, scene);
}

}  // namespace gltf

}  // namespace rambla::assets
