#include "render/passes/surface_detail.h"

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

SurfaceDetail surface_detail(const assets::Material& material, DetailGrade grade) {
    const auto has = [](const assets::TextureSlot& slot) {
        return slot.texture != assets::k_none;
    };
    const bool has_height = has(material.height_texture) && material.height_depth > 0.0f &&
                            material.alpha_mode != assets::AlphaMode::mask;
    if (has_height && grade == DetailGrade::occlusion) return SurfaceDetail::parallax_occlusion;
    if (has_height && grade == DetailGrade::parallax) return SurfaceDetail::parallax;
    if (has(material.normal_texture) && grade != DetailGrade::flat) return SurfaceDetail::normals;
    return has(material.metalness_roughness_texture) || has(material.occlusion_texture)
               ? SurfaceDetail::surface
               : SurfaceDetail::colour;
}

std::string detail_define(SurfaceDetail detail) {
    return std::to_string(static_cast<int>(detail));
}

std::uint32_t sampled_units(DetailGrade grade) {
    constexpr std::uint32_t k_all = (1u << UNIT_BESIDE_MATERIALS) - 1u;
    constexpr std::uint32_t k_height = 1u << UNIT_HEIGHT;
    constexpr std::uint32_t k_normal = 1u << UNIT_NORMAL;
    if (grade == DetailGrade::flat) return k_all & ~(k_height | k_normal);
    return grade == DetailGrade::normal ? k_all & ~k_height : k_all;
}

}  // namespace rambla::render
