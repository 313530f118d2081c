#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "render/gl/object.h"

namespace rambla::render::gl {

struct DeleteQuery {
    static void destroy(GLuint name) { glDeleteQueries(1, &name); }
};

class Query {
public:
    Query() = default;
    /// @param target  GL_TIME_ELAPSED, GL_TIMESTAMP, GL_SAMPLES_PASSED, …
    Query(std::string_view name, GLenum target);

    [[nodiscard]] GLuint name() const { return object_.name(); }
    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(object_); }
    /// The result, if the GPU has come so far; never waits.
    [[nodiscard]] std::optional<std::uint64_t> result() const;

private:
    Object<DeleteQuery> object_;
};

}  // namespace rambla::render::gl
