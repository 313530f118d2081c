#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "assets/material.h"
#include "render/settings.h"

namespace rambla::render {

/// Of a material's textures those that programs sample: the define DETAIL of shaders/material.glsl.
enum class SurfaceDetail : std::uint8_t { colour, surface, normals, parallax, parallax_occlusion };
inline constexpr std::size_t k_surface_details = 5;

/// What a material has of the grade that is wished for. Masked ones have no heights: what is cut out must be
/// the same in passes that know only depth.
[[nodiscard]] SurfaceDetail surface_detail(const assets::Material& material, DetailGrade grade);
[[nodiscard]] std::string detail_define(SurfaceDetail detail);

/// A bit per texture unit below UNIT_BESIDE_MATERIALS that some program of the grade samples.
[[nodiscard]] std::uint32_t sampled_units(DetailGrade grade);

}  // namespace rambla::render
