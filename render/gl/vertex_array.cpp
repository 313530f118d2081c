#include "render/gl/vertex_array.h"

namespace rambla::render::gl {

namespace {

GLuint create_vertex_array() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return name;
}

}  // namespace

VertexArray::VertexArray(std::string_view name) : object_{create_vertex_array()} {
    label(GL_VERTEX_ARRAY, object_.name(), name);
}

void VertexArray::attribute(const VertexAttribute& a) {
    glEnableVertexArrayAttrib(name(), a.location);
    if (a.integer) {
        glVertexArrayAttribIFormat(name(), a.location, a.components, a.type, a.offset);
    } else {
        glVertexArrayAttribFormat(name(), a.location, a.components, a.type, a.normalised ? GL_TRUE : GL_FALSE,
                                  a.offset);
    }
    glVertexArrayAttribBinding(name(), a.location, a.binding);
}

void VertexArray::vertex_buffer(GLuint binding, GLuint buffer, GLsizei stride) {
    glVertexArrayVertexBuffer(name(), binding, buffer, 0, stride);
}

void VertexArray::index_buffer(GLuint buffer) {
    glVertexArrayElementBuffer(name(), buffer);
}

}  // namespace rambla::render::gl
