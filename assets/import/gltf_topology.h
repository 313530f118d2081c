#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "assets/import/gltf_document.h"
#include "assets/mesh.h"

namespace rambla::assets::gltf {

/// Values as in the file.
enum class PrimitiveMode : std::uint8_t {
    points,
    lines,
    line_loop,
    line_strip,
    triangles,
    triangle_strip,
    triangle_fan
};

/// @throws Error  for numbers that are no mode
[[nodiscard]] PrimitiveMode primitive_mode(const Document& document, int mode, std::string_view element);

[[nodiscard]] Topology topology_of(PrimitiveMode mode);

/// Unrolls loops, strips and fans into lists, with the winding of glTF 2.0, section 3.7.2.1. Triangles of a
/// strip that repeat a vertex only join its parts and are left out; so is an incomplete last element.
[[nodiscard]] std::vector<std::uint32_t> to_list(PrimitiveMode mode, std::vector<std::uint32_t> indices);

/// Whether so many indices leave an incomplete last element.
[[nodiscard]] bool is_ragged(PrimitiveMode mode, std::size_t count);

}  // namespace rambla::assets::gltf
