#pragma once

#include <string_view>

#include "render/gl/object.h"

namespace rambla::render::gl {

struct DeleteVertexArray {
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};

/// One vertex attribute: where a shader's location finds its bytes.
struct VertexAttribute {
    GLuint location = 0;
    GLuint binding = 0;
    GLint components = 3;
    GLenum type = GL_FLOAT;
    bool normalised = false;
    bool integer = false;  ///< reaches the shader as integers
    GLuint offset = 0;
};

/// Layout of vertex buffers. One without attributes serves draws that make their vertices from gl_VertexID.
class VertexArray {
public:
    VertexArray() = default;
    explicit VertexArray(std::string_view name);

    [[nodiscard]] GLuint name() const { return object_.name(); }
    void attribute(const VertexAttribute& attribute);
    void vertex_buffer(GLuint binding, GLuint buffer, GLsizei stride);
    void index_buffer(GLuint buffer);
    void bind() const { glBindVertexArray(name()); }

private:
    Object<DeleteVertexArray> object_;
};

}  // namespace rambla::render::gl
