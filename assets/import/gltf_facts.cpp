#include "assets/import/gltf_facts.h"

#include <algorithm>

#include "assets/error.h"
#include "assets/import/gltf_convert.h"
#include "assets/import/gltf_document.h"
#include "assets/import/gltf_preflight.h"
#include "assets/import/gltf_texture.h"
#include "assets/import/image.h"

namespace rambla::assets {

namespace {

std::vector<std::string> sorted(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void append_names(std::vector<std::string>& names, const tinygltf::ExtensionMap& extensions) {
    for (const auto& [name, content] : extensions)
        names.push_back(name);
}

/// Those of the material and of the textures that it uses.
std::vector<std::string> extensions_of(const tinygltf::Material& material) {
    std::vector<std::string> names;
    append_names(names, material.extensions);
    append_names(names, material.pbrMetallicRoughness.extensions);
    append_names(names, material.pbrMetallicRoughness.baseColorTexture.extensions);
    append_names(names, material.pbrMetallicRoughness.metallicRoughnessTexture.extensions);
    append_names(names, material.normalTexture.extensions);
    append_names(names, material.occlusionTexture.extensions);
    append_names(names, material.emissiveTexture.extensions);
    return sorted(std::move(names));
}

std::string source_name(const tinygltf::Image& image) {
    if (image.bufferView >= 0) return "buffer";
    return image.uri.empty() || image.uri.starts_with("data:") ? "data URI" : image.uri;
}

ImageFacts image_facts(const gltf::Document& document, std::uint32_t image) {
    if (image == k_none) return {.source = "placeholder", .format = "unknown"};
    ImageFacts facts{.source = source_name(document.model.images[image]), .format = "unknown"};
    try {
        const gltf::EncodedImage encoded = gltf::encoded_image(document, image);
        facts.format = picture_format(encoded.bytes(), facts.source);
        facts.encoded_bytes = encoded.bytes().size();
    } catch (const Error&) {
        // The importer has warned of it and shows a placeholder.
        facts.format = "unknown";
    }
    return facts;
}

std::vector<SceneFacts> scenes_of(const tinygltf::Model& model) {
    std::vector<SceneFacts> scenes;
    for (const tinygltf::Scene& scene : model.scenes)
        scenes.push_back({.name = scene.name, .roots = {scene.nodes.begin(), scene.nodes.end()}});
    return scenes;
}

}  // namespace

GltfWithFacts import_gltf_with_facts(const std::filesystem::path& file, const ImportLimits& limits) {
    gltf::Document document = gltf::load_document(file, limits);
    GltfWithFacts out;
    const std::vector<std::uint32_t> image_sources = gltf::convert(document, out.scene);
    const tinygltf::Model& model = document.model;
    GltfFacts& facts = out.facts;
    facts.version = model.asset.version;
    facts.generator = model.asset.generator;
    facts.extensions_used = sorted(model.extensionsUsed);
    facts.extensions_required = sorted(model.extensionsRequired);
    for (const std::string& name : facts.extensions_used)
        if (!gltf::supports_extension(name)) facts.extensions_ignored.push_back(name);
    facts.scenes = scenes_of(model);
    if (model.defaultScene >= 0) facts.default_scene = static_cast<std::uint32_t>(model.defaultScene);
    for (const tinygltf::Material& material : model.materials)
        facts.material_extensions.push_back(extensions_of(material));
    for (const std::uint32_t image : image_sources)
        facts.images.push_back(image_facts(document, image));
    facts.document_bytes = std::filesystem::file_size(file);
    for (const tinygltf::Buffer& buffer : model.buffers)
        facts.buffer_bytes += buffer.data.size();
    return out;
}

}  // namespace rambla::assets
