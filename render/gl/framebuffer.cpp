#include "render/gl/framebuffer.h"

#include <stdexcept>
#include <string>

namespace rambla::render::gl {

namespace {

GLuint create_framebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return name;
}

}  // namespace

Framebuffer::Framebuffer(std::string_view name, const FramebufferDesc& desc)
    : object_{create_framebuffer()}, desc_{desc} {
    std::array<GLenum, k_max_colour_attachments> buffers{};
    for (std::size_t i = 0; i < desc.colours.size(); ++i) {
        const auto point = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i);
        const Attachment& colour = desc.colours[i];
        buffers[i] = colour.texture != 0 ? point : GLenum{GL_NONE};
        if (colour.texture == 0) continue;
        glNamedFramebufferTexture(object_.name(), point, colour.texture, static_cast<GLint>(colour.level));
    }
    if (desc.depth.texture != 0) {
        glNamedFramebufferTexture(object_.name(), GL_DEPTH_ATTACHMENT, desc.depth.texture,
                                  static_cast<GLint>(desc.depth.level));
    }
    glNamedFramebufferDrawBuffers(object_.name(), static_cast<GLsizei>(buffers.size()), buffers.data());
    label(GL_FRAMEBUFFER, object_.name(), name);
    const GLenum status = glCheckNamedFramebufferStatus(object_.name(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("framebuffer of " + std::string{name} + " is incomplete: GL status " +
                                 std::to_string(status));
    }
}

}  // namespace rambla::render::gl
