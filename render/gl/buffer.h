#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/object.h"

namespace rambla::render::gl {

struct DeleteBuffer {
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};

/// A part of a buffer, as glBindBufferRange takes it. Does not own.
struct BufferRange {
    GLuint buffer = 0;
    GLintptr offset = 0;
    GLsizeiptr size = 0;

    /// Binds to an indexed target: GL_UNIFORM_BUFFER or GL_SHADER_STORAGE_BUFFER. Empty ranges bind nothing
    /// (0).
    void bind(GLenum target, GLuint index) const;
};

/// Immutable storage.
class Buffer {
public:
    Buffer() = default;
    /// @param flags  of glNamedBufferStorage; GL_DYNAMIC_STORAGE_BIT allows write()
    Buffer(std::string_view name, std::size_t bytes, const void* data = nullptr, GLbitfield flags = 0);

    [[nodiscard]] GLuint name() const { return object_.name(); }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] BufferRange range() const { return {name(), 0, static_cast<GLsizeiptr>(size_)}; }
    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(object_); }
    void write(std::size_t offset, std::span<const std::byte> data);

private:
    Object<DeleteBuffer> object_;
    std::size_t size_ = 0;
};

/// Memory for data that the CPU writes anew each frame (instances, lights, uniforms, indirect commands): one
/// persistently mapped buffer with a region per frame in flight, guarded by fences. It grows when a frame
/// needs more; ranges handed out stay valid until the end of their frame.
class StreamBuffer {
public:
    static constexpr std::size_t k_frames_in_flight = 3;
    /// Covers the largest offset alignment that GL 4.5 allows an implementation to ask for.
    static constexpr std::size_t k_alignment = 256;

    StreamBuffer(std::string_view name, std::size_t bytes_per_frame);
    ~StreamBuffer();
    StreamBuffer(const StreamBuffer&) = delete;
    StreamBuffer& operator=(const StreamBuffer&) = delete;

    /// Starts a frame: waits, if it must, until the GPU has read what this region held.
    void begin_frame();
    /// Ends it: all commands that read this frame's ranges must have been issued.
    void end_frame();

    /// Reserves `bytes` of this frame; write them through the returned pointer before the commands that read
    /// them.
    struct Allocation {
        BufferRange range;
        std::byte* data = nullptr;
    };
    [[nodiscard]] Allocation allocate(std::size_t bytes);

    /// @param more  follows the values
    template <class T>
    [[nodiscard]] BufferRange upload(std::span<const T> values, std::span<const T> more = {}) {
        const Allocation a = allocate(values.size_bytes() + more.size_bytes());
        if (!values.empty()) std::memcpy(a.data, values.data(), values.size_bytes());
        if (!more.empty()) std::memcpy(a.data + values.size_bytes(), more.data(), more.size_bytes());
        return a.range;
    }
    template <class T>
    [[nodiscard]] BufferRange upload_value(const T& value) {
        return upload(std::span<const T>{&value, 1});
    }

    [[nodiscard]] std::size_t bytes_per_frame() const { return region_bytes_; }

private:
    void create(std::size_t region_bytes);

    std::string name_;
    Buffer buffer_;
    std::byte* mapped_ = nullptr;
    std::size_t region_bytes_ = 0;
    std::size_t region_ = 0;
    std::size_t used_ = 0;
    std::array<GLsync, k_frames_in_flight> fences_{};
    std::vector<Buffer> retired_;  ///< outgrown in this frame, still referred to by its ranges
};

}  // namespace rambla::render::gl
