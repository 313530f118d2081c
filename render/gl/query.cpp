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

std::optional<std::uint64_t> Query::result() const {
    constexpr GLuint64 k_untouched = ~GLuint64{0};  // more nanoseconds, or samples, than there can be
    GLuint64 value = k_untouched;
    glGetQueryObjectui64v(name(), GL_QUERY_RESULT_NO_WAIT, &value);
    if (value == k_untouched) return std::nullopt;
    return value;
}

}  // namespace rambla::render::gl
