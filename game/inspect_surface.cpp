#include "game/inspect_surface.h"

#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace rambla::game {
namespace {

using namespace assets;

nlohmann::json textures_of(const Material& material) {
    nlohmann::json used = nlohmann::json::object();
    const auto add = [&](const char* name, const TextureSlot& slot) {
        if (slot.texture == k_none) return;
        used[name] = {{"texture", slot.texture},
                      {"uv_set", slot.uv_set},
                      {"offset", {slot.offset.x, slot.offset.y}},
                      {"scale", {slot.scale.x, slot.scale.y}},
                      {"rotation_deg", glm::degrees(slot.rotation_rad)}};
    };
    add("base_colour", material.base_colour_texture);
    add("metalness_roughness", material.metalness_roughness_texture);
    add("normal", material.normal_texture);
    add("occlusion", material.occlusion_texture);
    add("emissive", material.emissive_texture);
    add("specular", material.specular_texture);
    add("specular_colour", material.specular_colour_texture);
    add("transmission", material.transmission_texture);
    add("height", material.height_texture);
    add("light_map", material.light_map_texture);
    return used;
}

const char* name_of(ColourSpace space) {
    return space == ColourSpace::srgb ? "sRGB" : "linear";
}

const char* name_of(WrapMode mode) {
    return mode == WrapMode::repeat ? "repeat" : mode == WrapMode::clamp_to_edge ? "clamp" : "mirror";
}

const char* name_of(Filter filter) {
    return filter == Filter::nearest ? "nearest" : "linear";
}

const char* name_of(MipFilter filter) {
    return filter == MipFilter::none ? "none" : filter == MipFilter::nearest ? "nearest" : "linear";
}

}  // namespace

nlohmann::json index_or_null(std::uint32_t index) {
    return index == k_none ? nlohmann::json(nullptr) : nlohmann::json(index);
}

nlohmann::json numbers(glm::vec3 v) {
    return nlohmann::json::array({v.x, v.y, v.z});
}

const char* inspected_format(const Image& image) {
    return image.format == PixelFormat::rgba8 ? "rgba8" : "rgba32f";
}

nlohmann::json inspected_material(const Material& material, const std::vector<std::string>& extensions) {
    const char* const alpha = material.alpha_mode == AlphaMode::blend  ? "blend"
                              : material.alpha_mode == AlphaMode::mask ? "mask"
                                                                       : "opaque";
    const glm::vec4 base = material.base_colour;
    return {{"name", material.name},
            {"alpha_mode", alpha},
            {"alpha_cutoff", material.alpha_cutoff},
            {"double_sided", material.double_sided},
            {"unlit", material.unlit},
            {"base_colour", {base.x, base.y, base.z, base.w}},
            {"metalness", material.metalness},
            {"roughness", material.roughness},
            {"normal_scale", material.normal_scale},
            {"occlusion_strength", material.occlusion_strength},
            {"emissive", numbers(material.emissive)},
            {"ior", material.ior},
            {"specular", material.specular},
            {"specular_colour", numbers(material.specular_colour)},
            {"transmission", material.transmission},
            {"height_depth", material.height_depth},
            {"optical_depth", material.optical_depth},
            {"light_map_strength", material.light_map_strength},
            {"textures", textures_of(material)},
            {"extensions", extensions}};
}

nlohmann::json inspected_texture(const Texture& texture) {
    return {{"name", texture.name},
            {"image", index_or_null(texture.image)},
            {"colour_space", name_of(texture.colour_space)},
            {"wrap", {name_of(texture.sampler.wrap_u), name_of(texture.sampler.wrap_v)}},
            {"magnify", name_of(texture.sampler.magnify)},
            {"minify", name_of(texture.sampler.minify)},
            {"mip", name_of(texture.sampler.mip)}};
}

nlohmann::json inspected_image(const Scene& scene, std::size_t index, const ImageFacts& facts) {
    const Image& image = scene.images[index];
    std::set<std::string> spaces;
    for (const Texture& texture : scene.textures)
        if (texture.image == index) spaces.insert(name_of(texture.colour_space));
    return {{"name", image.name},          {"width_px", image.width},
            {"height_px", image.height},   {"format", inspected_format(image)},
            {"colour_spaces", spaces},     {"source", facts.source},
            {"encoding", facts.format},    {"encoded_bytes", facts.encoded_bytes},
            {"bytes", image.texels.size()}};
}

}  // namespace rambla::game
