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
                          .emitters = static_cast<std::uint32_t>(into.emitters.size()),
                          .nodes = static_cast<std::uint32_t>(into.nodes.size()),
                          .skeletons = static_cast<std::uint32_t>(into.skeletons.size()),
                          .clips = static_cast<std::uint32_t>(into.clips.size())};
    for (Texture& texture : from.textures)
        shift(texture.image, at.images);
    for (Material& material : from.materials)
        for_each_texture_slot(material, [&](TextureSlot& slot) { shift(slot.texture, at.textures); });
    for (Model& model : from.models)
        for (ModelPart& part : model.parts) {
            shift(part.mesh, at.meshes);
            shift(part.material, at.materials);
        }
    for (Emitter& emitter : from.emitters)
        shift(emitter.material, at.materials);
    for (Node& node : from.nodes) {
        shift(node.parent, at.nodes);
        for (std::uint32_t& child : node.children)
            shift(child, at.nodes);
        shift(node.model, at.models);
        shift(node.camera, at.cameras);
        shift(node.light, at.lights);
        shift(node.emitter, at.emitters);
        shift(node.skeleton, at.skeletons);
        for (std::uint32_t& node_index : node.coarser)
            shift(node_index, at.nodes);
    }
    for (Skeleton& skeleton : from.skeletons)
        for (std::uint32_t& joint : skeleton.joints)
            shift(joint, at.nodes);
    for (Clip& clip : from.clips)
        for (Channel& channel : clip.channels)
            shift(channel.node, at.nodes);
    for (std::uint32_t& root : from.roots)
        shift(root, at.nodes);

    move_behind(into.images, from.images);
    move_behind(into.textures, from.textures);
    move_behind(into.materials, from.materials);
    move_behind(into.meshes, from.meshes);
    move_behind(into.models, from.models);
    move_behind(into.cameras, from.cameras);
    move_behind(into.lights, from.lights);
    move_behind(into.emitters, from.emitters);
    move_behind(into.nodes, from.nodes);
    move_behind(into.skeletons, from.skeletons);
    move_behind(into.clips, from.clips);
    move_behind(into.roots, from.roots);
    return at;
}

}  // namespace rambla::assets
