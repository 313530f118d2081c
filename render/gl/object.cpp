#include "render/gl/object.h"

namespace rambla::render::gl {

LiveCounts live_counts() {
    return {detail::live_objects.load(std::memory_order_relaxed),
            detail::live_bytes.load(std::memory_order_relaxed)};
}

void label(GLenum kind, GLuint name, std::string_view text) {
    glObjectLabel(kind, name, static_cast<GLsizei>(text.size()), text.data());
}

}  // namespace rambla::render::gl
