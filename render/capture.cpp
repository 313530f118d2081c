#include "render/capture.h"

#include <cstring>

#include "assets/assert.h"

namespace rambla::render {

namespace {

void finish_rgba8(std::byte* row, std::size_t texels) {
    for (std::size_t i = 0; i < texels; ++i)
        row[4 * i + 3] = std::byte{255};
}

void finish_rgba32f(std::byte* row, std::size_t texels, float scale) {
    for (std::size_t i = 0; i < texels; ++i) {
        glm::vec4 texel;
        std::memcpy(&texel, row + i * sizeof(texel), sizeof(texel));
        texel = glm::vec4{glm::vec3{texel} * scale, 1.0f};
        std::memcpy(row + i * sizeof(texel), &texel, sizeof(texel));
    }
}

}  // namespace

void Capture::add(RenderGraph& graph, const char* name, TextureHandle texture, assets::PixelFormat format,
                  float scale) {
    RAMBLA_ASSERT(!pending_, "a capture is taken before its object is used again");
    size_ = graph.desc(texture).size;
    format_ = format;
    scale_ = scale;
    pending_ = true;
    const std::size_t bytes = std::size_t{size_.x} * size_.y * assets::bytes_per_texel(format);
    if (buffer_.size() != bytes) buffer_ = gl::Buffer{name, bytes, nullptr, GL_MAP_READ_BIT};
    graph.add_pass(
        name,
        [&](PassBuilder& pass) {
            pass.read(texture, graph::Use::transfer);
            pass.side_effect();
        },
        [this, texture](PassContext& context) {
            const GLenum type =
                format_ == assets::PixelFormat::rgba8 ? GLenum{GL_UNSIGNED_BYTE} : GLenum{GL_FLOAT};
            glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.name());
            glGetTextureImage(context.texture(texture), 0, GL_RGBA, type,
                              static_cast<GLsizei>(buffer_.size()), nullptr);
            glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        });
}

assets::Image Capture::take() {
    RAMBLA_ASSERT(pending_, "only what was asked for can be taken");
    pending_ = false;
    assets::Image image;
    image.width = size_.x;
    image.height = size_.y;
    image.format = format_;
    image.texels.resize(buffer_.size());
    const auto* mapped = static_cast<const std::byte*>(
        glMapNamedBufferRange(buffer_.name(), 0, static_cast<GLsizeiptr>(buffer_.size()), GL_MAP_READ_BIT));
    RAMBLA_ASSERT(mapped != nullptr, "the buffer was made for reading");
    const std::size_t row_bytes = buffer_.size() / size_.y;
    for (std::uint32_t y = 0; y < size_.y; ++y) {  // GL's first row is the lowest
        std::byte* row = image.texels.data() + y * row_bytes;
        std::memcpy(row, mapped + (size_.y - 1 - y) * row_bytes, row_bytes);
        if (format_ == assets::PixelFormat::rgba8) {
            finish_rgba8(row, size_.x);
        } else {
            finish_rgba32f(row, size_.x, scale_);
        }
    }
    glUnmapNamedBuffer(buffer_.name());
    return image;
}

}  // namespace rambla::render
