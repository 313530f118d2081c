#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "render/gl/object.h"

namespace rambla::render::gl {

struct DeleteFramebuffer {
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};

inline constexpr std::size_t k_max_colour_attachments = 8;

/// One level of a texture to draw into.
struct Attachment {
    GLuint texture = 0;  ///< 0: none
    std::uint32_t level = 0;

    bool operator==(const Attachment&) const = default;
};

struct FramebufferDesc {
    std::array<Attachment, k_max_colour_attachments> colours{};
    Attachment depth;

    bool operator==(const FramebufferDesc&) const = default;
};

class Framebuffer {
public:
    Framebuffer() = default;
    /// @throws std::runtime_error  naming it, when the combination of attachments is incomplete
    Framebuffer(std::string_view name, const FramebufferDesc& desc);

    [[nodiscard]] GLuint name() const { return object_.name(); }
    [[nodiscard]] const FramebufferDesc& desc() const { return desc_; }

private:
    Object<DeleteFramebuffer> object_;
    FramebufferDesc desc_;
};

}  // namespace rambla::render::gl
