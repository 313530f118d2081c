#include "render/scene_materials.h"

#include <algorithm>

#include <cmath>

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

namespace {

static_assert(static_cast<std::uint32_t>(assets::AlphaMode::blend) == shared::k_alpha_blend);

// KHR_texture_transform: uv' = T · R · S · uv with R = [cos sin; −sin cos], as rotation counts
// counter-clockwise for a v axis that points down.
shared::UvTransform shader_transform(const assets::TextureSlot& slot) {
    const float c = std::cos(slot.rotation_rad);
    const float s = std::sin(slot.rotation_rad);
    return {.row0 = {c * slot.scale.x, s * slot.scale.y, slot.offset.x, static_cast<float>(slot.uv_set)},
            .row1 = {-s * slot.scale.x, c * slot.scale.y, slot.offset.y, 0.0f}};
}

/// The textures that a material binds, in the order of the units.
std::array<BoundTexture, k_material_units> bound_textures(const assets::Material& material,
                                                          const SceneTextures& textures) {
    std::array<BoundTexture, k_material_units> bound;
    const auto set = [&](std::size_t unit, const assets::TextureSlot& slot, const BoundTexture& neutral) {
        bound[unit] = slot.texture < textures.textures.size() ? textures.textures[slot.texture] : neutral;
    };
    set(UNIT_BASE_COLOUR, material.base_colour_texture, textures.white);
    set(UNIT_METALNESS_ROUGHNESS, material.metalness_roughness_texture, textures.white);
    set(UNIT_NORMAL, material.normal_texture, textures.flat_normal);
    set(UNIT_OCCLUSION, material.occlusion_texture, textures.white);
    set(UNIT_EMISSIVE, material.emissive_texture, textures.white);
    set(UNIT_SPECULAR, material.specular_texture, textures.white);
    set(UNIT_SPECULAR_COLOUR, material.specular_colour_texture, textures.white);
    set(UNIT_HEIGHT, material.height_texture, textures.white);
    set(UNIT_TRANSMISSION, material.transmission_texture, textures.white);
    set(UNIT_LIGHT_MAP, material.light_map_texture, textures.white);
    return bound;
}

void add_slots(SceneMaterials& result, const std::array<BoundTexture, k_material_units>& bound) {
    const auto material = static_cast<std::uint32_t>(result.slots.size());
    MaterialSlots& slots = result.slots.emplace_back();
    for (std::uint32_t unit = 0; unit < bound.size(); ++unit) {
        slots.textures[unit] = bound[unit].texture;
        slots.samplers[unit] = bound[unit].sampler;
        if (bound[unit].image != assets::k_none)
            result.slots_of_images[bound[unit].image].push_back({material, unit});
    }
}

bool lacks_normal_z(const assets::ProcessedScene& scene, const assets::Material& material) {
    const std::uint32_t texture = material.normal_texture.texture;
    if (texture >= scene.textures.size()) return false;
    const assets::TextureData& image = scene.images[scene.textures[texture].image];
    return image.normal_map && image.swizzle[2] == assets::ChannelSource::one;
}

/// Specular reflectance at normal incidence of what is no metal, before textures: KHR_materials_ior and
/// KHR_materials_specular.
glm::vec3 reflectance(const assets::Material& m) {
    const float root = m.ior == 0.0f ? 1.0f : (m.ior - 1.0f) / (m.ior + 1.0f);
    return root * root * m.specular_colour;
}

/// The same where there are no textures. The G-buffer keeps one number, so that a coloured reflection becomes
/// a grey one of the same luminance.
float dielectric_f0(const assets::Material& m) {
    const glm::vec3 f0 = glm::min(reflectance(m), glm::vec3{1.0f});
    return glm::dot(f0, glm::vec3{0.2126f, 0.7152f, 0.0722f}) * m.specular;
}

}  // namespace

shared::Material shader_material(const assets::Material& m, bool normal_z_is_missing) {
    std::uint32_t flags = 0;
    if (m.unlit) flags |= shared::k_material_unlit;
    if (m.double_sided) flags |= shared::k_material_double_sided;
    if (m.normal_texture.texture != assets::k_none) flags |= shared::k_material_has_normal_texture;
    if (normal_z_is_missing) flags |= shared::k_material_normal_z_is_missing;
    return {.base_colour = m.base_colour,
            .emissive_cutoff = glm::vec4{m.emissive, m.alpha_cutoff},
            .metalness = m.metalness,
            .roughness = m.roughness,
            .normal_scale = m.normal_scale,
            .occlusion_strength = m.occlusion_strength,
            .flags = flags,
            .alpha_mode = static_cast<std::uint32_t>(m.alpha_mode),
            .dielectric_f0 = dielectric_f0(m),
            .height_depth = m.height_texture.texture == assets::k_none ? 0.0f : m.height_depth,
            .specular = glm::vec4{reflectance(m), m.specular},
            .base_colour_uv = shader_transform(m.base_colour_texture),
            .metalness_roughness_uv = shader_transform(m.metalness_roughness_texture),
            .normal_uv = shader_transform(m.normal_texture),
            .occlusion_uv = shader_transform(m.occlusion_texture),
            .emissive_uv = shader_transform(m.emissive_texture),
            .specular_uv = shader_transform(m.specular_texture),
            .specular_colour_uv = shader_transform(m.specular_colour_texture),
            .height_uv = shader_transform(m.height_texture),
            .transmission_uv = shader_transform(m.transmission_texture),
            .light_map_uv = shader_transform(m.light_map_texture),
            .transmission = {m.transmission, m.light_map_strength, m.optical_depth, 0.0f}};
}

SceneMaterials upload_materials(const assets::ProcessedScene& scene, const SceneTextures& textures) {
    SceneMaterials result;
    result.materials = scene.materials;
    result.materials.emplace_back();
    result.slots_of_images.resize(scene.images.size());
    std::vector<shared::Material> rows;
    rows.reserve(result.materials.size());
    for (const assets::Material& material : result.materials) {
        rows.push_back(shader_material(material, lacks_normal_z(scene, material)));
        add_slots(result, bound_textures(material, textures));
    }
    result.buffer = gl::Buffer{"materials", rows.size() * sizeof(shared::Material), rows.data()};
    return result;
}

void rebind_image(SceneMaterials& materials, std::uint32_t image, GLuint texture) {
    for (const SlotOfImage& slot : materials.slots_of_images[image])
        materials.slots[slot.material].textures[slot.unit] = texture;
}

}  // namespace rambla::render
