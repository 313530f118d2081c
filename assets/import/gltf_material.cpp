#include "assets/import/gltf_material.h"

#include <algorithm>

#include "assets/import/gltf_files.h"
#include "assets/import/gltf_value.h"

namespace rambla::assets::gltf {

namespace {

/// A texture as an extension's object names it, in the form in which tinygltf gives the others.
tinygltf::TextureInfo texture_info(const tinygltf::Value& extension, const std::string& name) {
    tinygltf::TextureInfo info;
    if (!extension.Has(name)) return info;
    const tinygltf::Value& source = extension.Get(name);
    info.index = integer_of(source, "index", -1);
    info.texCoord = integer_of(source, "texCoord", 0);
    if (!source.Has("extensions")) return info;
    const tinygltf::Value& extensions = source.Get("extensions");
    if (extensions.Has("KHR_texture_transform"))
        info.extensions["KHR_texture_transform"] = extensions.Get("KHR_texture_transform");
    return info;
}

class MaterialImport {
public:
    MaterialImport(const Document& document, const tinygltf::Material& source, std::string element)
        : document_{document}, source_{source}, element_{std::move(element)} {}

    Material run() {
        material_.name = source_.name;
        read_base();
        read_surface();
        read_alpha();
        read_emission();
        material_.unlit = extension("KHR_materials_unlit") != nullptr;
        read_dielectric();
        read_height();
        read_optical_depth();
        read_light_map();
        return std::move(material_);
    }

private:
    template <class Info>
    TextureSlot slot(const Info& info, const std::string& name) const {
        TextureSlot out;
        if (info.index < 0) return out;
        const std::string element = element_ + "." + name;
        out.texture =
            document_.checked(info.index, document_.model.textures.size(), element + ".index", "texture");
        int uv_set = info.texCoord;
        if (const auto found = info.extensions.find("KHR_texture_transform");
            found != info.extensions.end()) {
            const tinygltf::Value& transform = found->second;
            out.offset = vector_of<2>(transform, "offset", out.offset);
            out.scale = vector_of<2>(transform, "scale", out.scale);
            out.rotation_rad = number_of(transform, "rotation", 0.0f);
            uv_set = integer_of(transform, "texCoord", uv_set);
        }
        if (uv_set != 0 && uv_set != 1) {
            document_.warn(element,
                           "TEXCOORD_" + std::to_string(uv_set) + " is not supported, TEXCOORD_0 is used");
            uv_set = 0;
        }
        out.uv_set = static_cast<std::uint32_t>(uv_set);
        return out;
    }

    void read_base() {
        const tinygltf::PbrMetallicRoughness& pbr = source_.pbrMetallicRoughness;
        for (int c = 0; c < 4; ++c)
            material_.base_colour[c] = unit_interval(pbr.baseColorFactor[static_cast<std::size_t>(c)]);
        material_.metalness = unit_interval(pbr.metallicFactor);
        material_.roughness = unit_interval(pbr.roughnessFactor);
        material_.base_colour_texture = slot(pbr.baseColorTexture, "pbrMetallicRoughness.baseColorTexture");
        material_.metalness_roughness_texture =
            slot(pbr.metallicRoughnessTexture, "pbrMetallicRoughness.metallicRoughnessTexture");
    }

    void read_surface() {
        material_.normal_texture = slot(source_.normalTexture, "normalTexture");
        material_.normal_scale = finite_float(source_.normalTexture.scale);
        material_.occlusion_texture = slot(source_.occlusionTexture, "occlusionTexture");
        material_.occlusion_strength = unit_interval(source_.occlusionTexture.strength);
        material_.double_sided = source_.doubleSided;
    }

    void read_alpha() {
        if (source_.alphaMode == "MASK")
            material_.alpha_mode = AlphaMode::mask;
        else if (source_.alphaMode == "BLEND")
            material_.alpha_mode = AlphaMode::blend;
        else if (source_.alphaMode != "OPAQUE" && !source_.alphaMode.empty())
            document_.warn(element_ + ".alphaMode",
                           in_quotes(source_.alphaMode) + " is unknown, OPAQUE is used");
        material_.alpha_cutoff = std::max(finite_float(source_.alphaCutoff), 0.0f);
    }

    void read_emission() {
        material_.emissive_texture = slot(source_.emissiveTexture, "emissiveTexture");
        if (source_.emissiveFactor.size() == 3)
            for (int c = 0; c < 3; ++c)
                material_.emissive[c] = unit_interval(source_.emissiveFactor[static_cast<std::size_t>(c)]);
        if (const tinygltf::Value* const strength = extension("KHR_materials_emissive_strength"))
            material_.emissive *= std::max(number_of(*strength, "emissiveStrength", 1.0f), 0.0f);
    }

    const tinygltf::Value* extension(const std::string& name) const {
        const auto found = source_.extensions.find(name);
        return found == source_.extensions.end() ? nullptr : &found->second;
    }

    void read_dielectric() {
        if (const tinygltf::Value* const ior = extension("KHR_materials_ior")) {
            const float index = number_of(*ior, "ior", material_.ior);
            material_.ior = index == 0.0f ? 0.0f : std::max(index, 1.0f);
            if (index != 0.0f && index < 1.0f)
                document_.warn(element_ + ".extensions.KHR_materials_ior.ior",
                               number_text(index) + " is neither 0 nor at least 1, and becomes 1");
        }
        if (const tinygltf::Value* const specular = extension("KHR_materials_specular")) {
            material_.specular = unit_interval(number_of(*specular, "specularFactor", 1.0f));
            material_.specular_colour =
                glm::max(vector_of<3>(*specular, "specularColorFactor", glm::vec3{1.0f}), glm::vec3{0.0f});
            const std::string element = "extensions.KHR_materials_specular.";
            material_.specular_texture =
                slot(texture_info(*specular, "specularTexture"), element + "specularTexture");
            material_.specular_colour_texture =
                slot(texture_info(*specular, "specularColorTexture"), element + "specularColorTexture");
        }
        if (const tinygltf::Value* const transmission = extension("KHR_materials_transmission")) {
            material_.transmission = unit_interval(number_of(*transmission, "transmissionFactor", 0.0f));
            material_.transmission_texture =
                slot(texture_info(*transmission, "transmissionTexture"),
                     "extensions.KHR_materials_transmission.transmissionTexture");
        }
    }

    /// The texture of an entry of the extras. Extras are anybody's: what does not fit is left out, not an
    /// error.
    /// @param what  of the surface it is, for warnings
    TextureSlot extra_slot(const std::string& name, const char* what) const {
        if (!source_.extras.IsObject() || !source_.extras.Has(name)) return {};
        const tinygltf::TextureInfo info = texture_info(source_.extras, name);
        const auto count = static_cast<int>(document_.model.textures.size());
        if (info.index < 0 || info.index >= count) {
            document_.warn(element_ + ".extras." + name, "index is " + std::to_string(info.index) +
                                                             ", expected one of " + std::to_string(count) +
                                                             " textures: " + what + " left out");
            return {};
        }
        return slot(info, "extras." + name);
    }

    /// glTF knows no heights.
    void read_height() {
        const std::string name = "ramblaHeight";
        const TextureSlot heights = extra_slot(name, "heights are");
        if (heights.texture == k_none) return;
        if (material_.normal_texture.texture != k_none && material_.normal_texture.uv_set != heights.uv_set) {
            document_.warn(element_ + ".extras." + name,
                           "its coordinates are not those of the normal texture: heights are left out");
            return;
        }
        material_.height_texture = heights;
        const float depth = number_of(source_.extras.Get(name), "depth", -1.0f);
        material_.height_depth = std::clamp(depth, 0.0f, k_max_height_depth);
        if (depth != material_.height_depth)
            document_.warn(element_ + ".extras." + name + ".depth",
                           "is no number from 0 to " + number_text(k_max_height_depth) + ", " +
                               number_text(material_.height_depth) + " is used");
    }

    /// Nor does it know light maps.
    void read_light_map() {
        const std::string name = "ramblaLightMap";
        material_.light_map_texture = extra_slot(name, "the light map is");
        if (material_.light_map_texture.texture == k_none) return;
        const tinygltf::Value& source = source_.extras.Get(name);
        if (!source.Has("strength")) return;
        const float strength = number_of(source, "strength", -1.0f);
        material_.light_map_strength = std::max(strength, 0.0f);
        if (strength < 0.0f)
            document_.warn(element_ + ".extras." + name + ".strength", "is no number from 0 on, 0 is used");
    }

    /// Nor haze.
    void read_optical_depth() {
        const std::string name = "ramblaOpticalDepth";
        if (!source_.extras.IsObject() || !source_.extras.Has(name)) return;
        const float depth = number_of(source_.extras, name, -1.0f);
        material_.optical_depth = std::clamp(depth, 0.0f, k_max_optical_depth);
        if (depth != material_.optical_depth)
            document_.warn(element_ + ".extras." + name,
                           "is no number from 0 to " + number_text(k_max_optical_depth) + ", " +
                               number_text(material_.optical_depth) + " is used");
    }

    const Document& document_;
    const tinygltf::Material& source_;
    std::string element_;
    Material material_;
};

}  // namespace

void import_materials(const Document& document, Scene& scene) {
    const std::vector<tinygltf::Material>& materials = document.model.materials;
    for (std::size_t i = 0; i < materials.size(); ++i)
        scene.materials.push_back(MaterialImport{document, materials[i], element_name("materials", i)}.run());
}

}  // namespace rambla::assets::gltf
