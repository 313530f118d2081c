#include "assets/export/gltf_material.h"

#include <algorithm>
#include <cmath>

namespace rambla::assets {

namespace {

using Json = nlohmann::json;

// Numbers of the glTF format, which are those of OpenGL.
constexpr int k_nearest = 9728;
constexpr int k_linear = 9729;
constexpr int k_mip_nearest = 256;  ///< added to k_nearest or k_linear: *_MIPMAP_NEAREST
constexpr int k_mip_linear = 258;   ///< *_MIPMAP_LINEAR

int wrap_number(WrapMode mode) {
    switch (mode) {
        case WrapMode::clamp_to_edge:
            return 33071;
        case WrapMode::mirrored_repeat:
            return 33648;
        case WrapMode::repeat:
            break;
    }
    return 10497;
}

Json sampler_json(const Sampler& sampler) {
    int minify = sampler.minify == Filter::nearest ? k_nearest : k_linear;
    if (sampler.mip == MipFilter::nearest) minify += k_mip_nearest;
    if (sampler.mip == MipFilter::linear) minify += k_mip_linear;
    return {{"wrapS", wrap_number(sampler.wrap_u)},
            {"wrapT", wrap_number(sampler.wrap_v)},
            {"magFilter", sampler.magnify == Filter::nearest ? k_nearest : k_linear},
            {"minFilter", minify}};
}

class MaterialExport {
public:
    MaterialExport(const Material& material, std::set<std::string>& extensions)
        : material_{material}, extensions_{extensions} {}

    Json run() {
        Json out{{"pbrMetallicRoughness", surface()}};
        if (!material_.name.empty()) out["name"] = material_.name;
        if (material_.double_sided) out["doubleSided"] = true;
        if (material_.alpha_mode == AlphaMode::blend) out["alphaMode"] = "BLEND";
        if (material_.alpha_mode == AlphaMode::mask) {
            out["alphaMode"] = "MASK";
            out["alphaCutoff"] = material_.alpha_cutoff;
        }
        if (material_.normal_texture.texture != k_none) {
            out["normalTexture"] = slot(material_.normal_texture);
            out["normalTexture"]["scale"] = material_.normal_scale;
        }
        if (material_.occlusion_texture.texture != k_none) {
            out["occlusionTexture"] = slot(material_.occlusion_texture);
            out["occlusionTexture"]["strength"] = material_.occlusion_strength;
        }
        add_emission(out);
        add_dielectric(out);
        if (material_.height_texture.texture != k_none) {
            Json& height = out["extras"]["ramblaHeight"];
            height = slot(material_.height_texture);
            height["depth"] = material_.height_depth;
        }
        if (material_.optical_depth > 0.0f) out["extras"]["ramblaOpticalDepth"] = material_.optical_depth;
        if (material_.light_map_texture.texture != k_none) {
            Json& light_map = out["extras"]["ramblaLightMap"];
            light_map = slot(material_.light_map_texture);
            light_map["strength"] = material_.light_map_strength;
        }
        if (material_.unlit) use(out, "KHR_materials_unlit") = Json::object();
        return out;
    }

private:
    Json& use(Json& element, const std::string& extension) {
        extensions_.insert(extension);
        return element["extensions"][extension];
    }

    Json slot(const TextureSlot& slot) {
        Json out{{"index", slot.texture}};
        if (slot.uv_set != 0) out["texCoord"] = slot.uv_set;
        const TextureSlot identity;
        if (slot.offset != identity.offset || slot.scale != identity.scale || slot.rotation_rad != 0.0f)
            use(out, "KHR_texture_transform") = {{"offset", {slot.offset.x, slot.offset.y}},
                                                 {"scale", {slot.scale.x, slot.scale.y}},
                                                 {"rotation", slot.rotation_rad}};
        return out;
    }

    Json surface() {
        const glm::vec4 colour = material_.base_colour;
        Json out{{"baseColorFactor", {colour.x, colour.y, colour.z, colour.w}},
                 {"metallicFactor", material_.metalness},
                 {"roughnessFactor", material_.roughness}};
        if (material_.base_colour_texture.texture != k_none)
            out["baseColorTexture"] = slot(material_.base_colour_texture);
        if (material_.metalness_roughness_texture.texture != k_none)
            out["metallicRoughnessTexture"] = slot(material_.metalness_roughness_texture);
        return out;
    }

    /// The factor is limited to 1; what exceeds it becomes a strength.
    void add_emission(Json& out) {
        if (material_.emissive_texture.texture != k_none)
            out["emissiveTexture"] = slot(material_.emissive_texture);
        const glm::vec3 radiance = material_.emissive;
        const float strength = power_of_two_above(radiance);
        const glm::vec3 factor = radiance / strength;
        if (radiance != glm::vec3{0.0f}) out["emissiveFactor"] = {factor.x, factor.y, factor.z};
        if (strength > 1.0f) use(out, "KHR_materials_emissive_strength")["emissiveStrength"] = strength;
    }

    void add_dielectric(Json& out) {
        const Material usual;
        if (material_.ior != usual.ior) use(out, "KHR_materials_ior")["ior"] = material_.ior;
        const bool has_texture = material_.specular_texture.texture != k_none ||
                                 material_.specular_colour_texture.texture != k_none;
        if (has_texture || material_.specular != usual.specular ||
            material_.specular_colour != usual.specular_colour) {
            const glm::vec3 colour = material_.specular_colour;
            Json& specular = use(out, "KHR_materials_specular");
            specular = {{"specularFactor", material_.specular},
                        {"specularColorFactor", {colour.x, colour.y, colour.z}}};
            if (material_.specular_texture.texture != k_none)
                specular["specularTexture"] = slot(material_.specular_texture);
            if (material_.specular_colour_texture.texture != k_none)
                specular["specularColorTexture"] = slot(material_.specular_colour_texture);
        }
        const bool transmits =
            material_.transmission > 0.0f || material_.transmission_texture.texture != k_none;
        if (!transmits) return;
        Json& transmission = use(out, "KHR_materials_transmission");
        transmission["transmissionFactor"] = material_.transmission;
        if (material_.transmission_texture.texture != k_none)
            transmission["transmissionTexture"] = slot(material_.transmission_texture);
    }

    const Material& material_;
    std::set<std::string>& extensions_;
};

}  // namespace

float power_of_two_above(glm::vec3 v) {
    int exponent = 0;
    const bool is_power = std::frexp(std::max({v.x, v.y, v.z, 1.0f}), &exponent) == 0.5f;
    return std::ldexp(1.0f, is_power ? exponent - 1 : exponent);
}

Json materials_json(const Scene& scene, std::set<std::string>& extensions) {
    Json out = Json::object();
    for (const Material& material : scene.materials)
        out["materials"].push_back(MaterialExport{material, extensions}.run());
    std::vector<Sampler> samplers;
    for (const Texture& texture : scene.textures) {
        const auto known = std::find(samplers.begin(), samplers.end(), texture.sampler);
        Json entry{{"sampler", known - samplers.begin()}};
        if (known == samplers.end()) samplers.push_back(texture.sampler);
        if (texture.image != k_none) entry["source"] = texture.image;
        if (!texture.name.empty()) entry["name"] = texture.name;
        out["textures"].push_back(std::move(entry));
    }
    for (const Sampler& sampler : samplers)
        out["samplers"].push_back(sampler_json(sampler));
    return out;
}

}  // namespace rambla::assets
