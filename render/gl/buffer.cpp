#include "render/gl/buffer.h"

#include <algorithm>

#include "assets/assert.h"

namespace rambla::render::gl {

namespace {

GLuint create_buffer() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return name;
}

constexpr std::size_t round_up(std::size_t value, std::size_t alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

}  // namespace

void BufferRange::bind(GLenum target, GLuint index) const {
    if (size == 0) {
        glBindBufferBase(target, index, 0);
    } else {
        glBindBufferRange(target, index, buffer, offset, size);
    }
}

Buffer::Buffer(std::string_view name, std::size_t bytes, const void* data, GLbitfield flags)
    : object_{create_buffer(), bytes}, size_{bytes} {
    // GL refuses storage of zero bytes; an empty scene must still have buffers to bind.
    glNamedBufferStorage(object_.name(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)), data,
                         flags);
    label(GL_BUFFER, object_.name(), name);
}

void Buffer::write(std::size_t offset, std::span<const std::byte> data) {
    RAMBLA_ASSERT(offset + data.size() <= size_, "writes stay inside the buffer");
    glNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()),
                         data.data());
}

StreamBuffer::StreamBuffer(std::string_view name, std::size_t bytes_per_frame) : name_{name} {
    create(round_up(std::max<std::size_t>(bytes_per_frame, 1), k_alignment));
}

StreamBuffer::~StreamBuffer() {
    for (GLsync fence : fences_)
        glDeleteSync(fence);
}

void StreamBuffer::create(std::size_t region_bytes) {
    constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const std::size_t bytes = region_bytes * k_frames_in_flight;
    buffer_ = Buffer{name_, bytes, nullptr, flags};
    mapped_ = static_cast<std::byte*>(
        glMapNamedBufferRange(buffer_.name(), 0, static_cast<GLsizeiptr>(bytes), flags));
    RAMBLA_ASSERT(mapped_ != nullptr, "persistent mapping is core since 4.4");
    region_bytes_ = region_bytes;
}

void StreamBuffer::begin_frame() {
    region_ = (region_ + 1) % k_frames_in_flight;
    used_ = 0;
    GLsync& fence = fences_[region_];
    if (fence == nullptr) return;
    constexpr GLuint64 one_second_ns = 1'000'000'000;
    while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, one_second_ns) == GL_TIMEOUT_EXPIRED) {
    }
    glDeleteSync(fence);
    fence = nullptr;
}

void StreamBuffer::end_frame() {
    glDeleteSync(fences_[region_]);
    fences_[region_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    retired_.clear();
}

StreamBuffer::Allocation StreamBuffer::allocate(std::size_t bytes) {
    if (used_ + bytes > region_bytes_) {
        // The new buffer's regions have no readers yet, so the fences, which guard the old one's, may stay as
        // they are: GL itself keeps the old storage until its commands are done.
        retired_.push_back(std::move(buffer_));
        create(std::max(2 * region_bytes_, round_up(bytes, k_alignment)));
        used_ = 0;
    }
    const std::size_t offset = region_ * region_bytes_ + used_;
    used_ = round_up(used_ + bytes, k_alignment);
    return {.range = {.buffer = buffer_.name(),
                      .offset = static_cast<GLintptr>(offset),
                      .size = static_cast<GLsizeiptr>(bytes)},
            .data = mapped_ + offset};
}

}  // namespace rambla::render::gl
