#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/gl/buffer.h"
#include "render/gl/framebuffer.h"
#include "render/gl/texture.h"

namespace rambla::render::graph {

/// What a transient resource needs: a texture, or a buffer of `buffer_bytes` where that is not 0.
struct Layout {
    gl::TextureDesc texture;
    std::size_t buffer_bytes = 0;

    bool operator==(const Layout&) const = default;
};

/// Frames after which memory that nothing asks for is given back: long enough for what comes and goes with
/// every second or third frame, short enough for a switched-off effect to be gone in a blink.
inline constexpr std::uint32_t k_idle_frames = 8;

/// Textures and buffers that transient resources borrow for a frame.
class Pool {
public:
    struct Memory {
        GLuint name = 0;
        std::uint64_t id = 0;  ///< of a texture, see gl::Texture::id
    };

    /// Makes all memory free again, and deletes what was free for k_idle_frames.
    void begin_frame();
    /// Memory that nobody else has in this frame.
    [[nodiscard]] Memory acquire(const Layout& layout, const char* name);
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct Entry {
        Layout layout;
        gl::Texture texture;
        gl::Buffer buffer;
        bool taken = false;
        std::uint32_t idle_frames = 0;
    };
    std::vector<Entry> entries_;
};

/// Framebuffers by their attachments, made when first asked for and dropped when idle.
class FramebufferCache {
public:
    /// Attachments by texture id, which, unlike a GL name, is never used again.
    struct Key {
        std::array<std::uint64_t, gl::k_max_colour_attachments> colours{};
        std::array<std::uint32_t, gl::k_max_colour_attachments> levels{};
        std::uint64_t depth = 0;

        bool operator==(const Key&) const = default;
    };

    void begin_frame();
    [[nodiscard]] GLuint get(const Key& key, const gl::FramebufferDesc& desc, const char* name);

private:
    struct Entry {
        Key key;
        gl::Framebuffer framebuffer;
        std::uint32_t idle_frames = 0;
    };
    std::vector<Entry> entries_;
};

}  // namespace rambla::render::graph
