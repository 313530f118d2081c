#include "render/gl/query.h"

namespace rambla::render::gl {

namespace {

GLuint create_query(GLenum target) {
    GLuint name = 0;
    glCreateQueries(target, 1, &name);
    return name;
}

}  // namespace

Query::Query(std::string_view name, GLenum target) : object_{create_query(target)} {
    label(GL_QUERY, object_.name(), name);
}

std::uint64_t Query::result() const {
    GLuint64 value = 0;
    glGetQueryObjectui64v(name(), GL_QUERY_RESULT, &value);
    return value;
}

}  // namespace rambla::render::gl
