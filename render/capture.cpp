#include "render/capture.h"

#include <array>
#include <cstring>

#include "assets/assert.h"

namespace rambla::render {

namespace {

struct Transfer {
    GLenum format;
    GLenum type;
    std::size_t bytes_per_texel;
};

/// By CapturedAs.
constexpr std::array<Transfer, 3> k_transfers{
    {{GL_RGBA, GL_UNSIGNED_BYTE, 4}, {GL_RGBA, GL_FLOAT, 16}, {GL_RED_INTEGER, GL_UNSIGNED_INT, 4}}};

const Transfer& transfer_of(CapturedAs what) {
    return k_transfers[static_cast<std::size_t>(what)];
}

void finish_bytes(std::vector<std::byte>& texels) {
    for (std::size_t i = 3; i < texels.size(); i += 4)
        texels[i] = std::byte{255};
}

void finish_floats(std::vector<std::byte>& texels, float scale) {
    for (std::size_t i = 0; i < texels.size(); i += sizeof(glm::vec4)) {
        glm::vec4 texel;
        std::memcpy(&texel, &texels[i], sizeof(texel));
        texel = glm::vec4{glm::vec3{texel} * scale, 1.0f};
        std::memcpy(&texels[i], &texel, sizeof(texel));
    }
}

}  // namespace

void Capture::add(RenderGraph& graph, const char* name, TextureHandle texture, CapturedAs what, float scale) {
    RAMBLA_ASSERT(!pending_, "a capture is taken before its object is used again");
    size_ = graph.desc(texture).size;
    what_ = what;
    scale_ = scale;
    pending_ = true;
    const std::size_t bytes = std::size_t{size_.x} * size_.y * transfer_of(what).bytes_per_texel;
    if (buffer_.size() != bytes) buffer_ = gl::Buffer{name, bytes, nullptr, GL_MAP_READ_BIT};
    graph.add_pass(
        name,
        [&](PassBuilder& pass) {
            pass.read(texture, graph::Use::transfer);
            pass.side_effect();
        },
        [this, texture](PassContext& context) {
            const Transfer& transfer = transfer_of(what_);
            glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.name());
            glGetTextureImage(context.texture(texture), 0, transfer.format, transfer.type,
                              static_cast<GLsizei>(buffer_.size()), nullptr);
            glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        });
}

void Capture::copy_rows(std::byte* to) {
    RAMBLA_ASSERT(pending_, "only what was asked for can be taken");
    pending_ = false;
    const auto* mapped = static_cast<const std::byte*>(
        glMapNamedBufferRange(buffer_.name(), 0, static_cast<GLsizeiptr>(buffer_.size()), GL_MAP_READ_BIT));
    RAMBLA_ASSERT(mapped != nullptr, "the buffer was made for reading");
    const std::size_t row_bytes = buffer_.size() / size_.y;
    for (std::uint32_t y = 0; y < size_.y; ++y)  // GL's first row is the lowest
        std::memcpy(to + y * row_bytes, mapped + (size_.y - 1 - y) * row_bytes, row_bytes);
    glUnmapNamedBuffer(buffer_.name());
}

assets::Image Capture::take() {
    assets::Image image;
    image.width = size_.x;
    image.height = size_.y;
    image.format = what_ == CapturedAs::bytes ? assets::PixelFormat::rgba8 : assets::PixelFormat::rgba32f;
    image.texels.resize(buffer_.size());
    copy_rows(image.texels.data());
    if (what_ == CapturedAs::bytes) {
        finish_bytes(image.texels);
    } else {
        finish_floats(image.texels, scale_);
    }
    return image;
}

ObjectImage Capture::take_objects() {
    ObjectImage image{.width = size_.x, .height = size_.y, .ids = {}};
    image.ids.resize(std::size_t{size_.x} * size_.y);
    copy_rows(reinterpret_cast<std::byte*>(image.ids.data()));
    for (std::uint32_t& id : image.ids)
        --id;  // none, which is 0, becomes assets::k_none
    return image;
}

}  // namespace rambla::render
