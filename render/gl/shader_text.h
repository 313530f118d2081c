#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "render/shader_source.h"

namespace rambla::render::gl {

/// The text that a driver compiles, and where each of its lines comes from. No #line directives: they are
/// what drivers get wrong (Mesa forgets the file at most errors), while every driver can count the lines of
/// what it was given.
struct ShaderText {
    struct Origin {
        std::uint32_t file = 0;  ///< index into `files`
        std::uint32_t line = 0;  ///< counted from 1
    };
    std::string text;
    std::vector<std::string> files;  ///< [0] is what this code itself put in front of the files
    std::vector<Origin> origins;     ///< per line of `text`
};

/// Version, extensions and `defines`, then the file with every `#include "path"` replaced by that file's
/// text, each file once. Paths count from render/shaders; the form "render/shaders/path", which C++
/// understands too, means the same. Includes in angle brackets belong to C++ and vanish. Files must not hold
/// a #version line.
/// @throws ShaderError  naming file and line of an include that cannot be read
[[nodiscard]] ShaderText expand_shader(const std::string& path, const ShaderSource& source,
                                       const std::vector<std::pair<std::string, std::string>>& defines);

/// A driver's log about `text` with `0:12(5)`, `0(12)` or `ERROR: 0:12` turned into `file.glsl:7`.
[[nodiscard]] std::string map_shader_log(const std::string& log, const ShaderText& text);

}  // namespace rambla::render::gl
