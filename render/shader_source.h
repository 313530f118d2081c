#pragma once

#include <functional>
#include <string>

namespace rambla::render {

/// Text of a shader file by its path under render/shaders; throws if there is none.
using ShaderSource = std::function<std::string(const std::string& path)>;

/// Text of a file under render/shaders as it was at build. @throws std::out_of_range  naming the path
[[nodiscard]] std::string embedded_shader(const std::string& path);

}  // namespace rambla::render
