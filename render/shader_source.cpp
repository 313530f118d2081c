#include "render/shader_source.h"

#include <stdexcept>

#include "render/embedded_shaders.h"

namespace rambla::render {

std::string embedded_shader(const std::string& path) {
    const auto found = embedded_shaders().find(path);
    if (found == embedded_shaders().end()) throw std::out_of_range("no shader file " + path);
    return std::string{found->second};
}

}  // namespace rambla::render
