#include "assets/library.h"

#include <iterator>

namespace rambla::assets {

namespace {

void shift(std::uint32_t& index, std::uint32_t offset) {
    if (index != k_none) index += offset;
}

template <class T>
void move_behind(std::vector<T>& into, std::vector<T>& from) {
    into.insert(into.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

SceneOffsets append(Scene& into, Scene from) {
    const SceneOffsets at{.images = static_cast<std::uint32_t>(into.images.size()),
                          .textures = static_cast<std::uint32_t>(into.textures.size()),
                          .materials = static_cast<std::uint32_t>(into.materials.size()),
                          .meshes = static_cast<std::uint32_t>(into.meshes.size()),
                          .models = static_cast<std::uint32_t>(into.models.size()),
                          .cameras = static_cast<std::uint32_t>(into.cameras.size()),
                          .lights = static_cast<std::uint32_t>(into.lights.size()),
                          .nodes = static_cast<std::uint32_t>(into.nodes.size())};
    for (Texture& texture : from.textures)
        shift(texture.image, at.images);
    for (Material& material : from.materials)
        for (TextureSlot* slot :
             {&material.base_colour_texture, &material.metalness_roughness_texture, &material.normal_texture,
              &material.occlusion_texture, &material.emissive_texture})
            shift(slot->texture, at.textures);
    for (Model& model : from.models)
        for (ModelPart& part : model.parts) {
            shift(part.mesh, at.meshes);
            shift(part.material, at.materials);
        }
    for (Node& node : from.nodes) {
        shift(node.parent, at.nodes);
        for (std::uint32_t& child : node.children)
            shift(child, at.nodes);
        shift(node.model, at.models);
        shift(node.camera, at.cameras);
        shift(node.light, at.lights);
    }
    for (std::uint32_t& root : from.roots)
        shift(root, at.nodes);

    move_behind(into.images, from.images);
    move_behind(into.textures, from.textures);
    move_behind(into.materials, from.materials);
    move_behind(into.meshes, from.meshes);
    move_behind(into.models, from.models);
    move_behind(into.cameras, from.cameras);
    move_behind(into.lights, from.lights);
    move_behind(into.nodes, from.nodes);
    move_behind(into.roots, from.roots);
    return at;
}

}  // namespace rambla::assets
