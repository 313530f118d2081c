// Lets C++ and GLSL read one struct: the field types of GLSL under their own names. Structs lie between
// SHARED_BEGIN and SHARED_END. Their layout is std430 (and std140 where a uniform block holds them): use
// vec4, mat4, uvec4 and scalars in groups of four, name all padding, and assert the size on the C++ side.
#ifndef RAMBLA_SHARED_TYPES_H
#define RAMBLA_SHARED_TYPES_H

#ifdef __cplusplus

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace rambla::render::shared {
using glm::ivec4;
using glm::mat4;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
}  // namespace rambla::render::shared

#define SHARED_BEGIN namespace rambla::render::shared {
#define SHARED_END }
#define SHARED_CONSTANT inline constexpr std::uint32_t

#else

#define SHARED_BEGIN
#define SHARED_END
#define SHARED_CONSTANT const uint

#endif
#endif
