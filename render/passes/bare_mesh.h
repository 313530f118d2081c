#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rambla::render {

/// Defines of mesh.vert.glsl for a program that draws meshes and shades nothing: no normal map, emission,
/// tinted reflection, glass or light map reaches its fragments.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> bare_mesh_defines(bool skinned, bool morphed);

}  // namespace rambla::render
