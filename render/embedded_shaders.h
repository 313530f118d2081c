#pragma once

#include <string_view>
#include <unordered_map>

namespace rambla::render {

/// Every file under render/shaders by its path there, as it was at build (made by cmake/embed_shaders.cmake).
[[nodiscard]] const std::unordered_map<std::string_view, std::string_view>& embedded_shaders();

}  // namespace rambla::render
