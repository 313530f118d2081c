#include "render/graph/graph.h"

#include <algorithm>
#include <stdexcept>

#include "assets/assert.h"
#include "render/graph/graph_state.h"

namespace rambla::render {

RenderGraph::RenderGraph() : state_{std::make_unique<State>()} {}
RenderGraph::~RenderGraph() = default;

std::uint32_t RenderGraph::State::layout_index(const graph::Layout& layout) {
    const auto found = std::find(layouts.begin(), layouts.end(), layout);
    if (found == layouts.end()) {
        layouts.push_back(layout);
        return static_cast<std::uint32_t>(layouts.size() - 1);
    }
    return static_cast<std::uint32_t>(found - layouts.begin());
}

std::uint32_t RenderGraph::State::add(const ResourceInfo& resource, bool keep) {
    resources.push_back(resource);
    return recording.add_resource(
        {.transient = resource.kind == Kind::transient, .keep = keep, .layout = resource.layout});
}

void RenderGraph::begin_frame() {
    state_->recording.clear();
    state_->resources.clear();
    state_->layouts.clear();
    state_->passes.clear();
    state_->plan = nullptr;
}

std::uint32_t RenderGraph::new_pass(const char* name) {
    state_->passes.emplace_back().name = name;
    return state_->recording.add_pass();
}

void RenderGraph::set_callback(std::uint32_t pass, graph::Callback<PassContext&> callback) {
    state_->passes[pass].callback = callback;
}

TextureHandle RenderGraph::import_texture(const char* name, const gl::Texture& texture, bool keep) {
    const std::uint32_t layout = state_->layout_index({.texture = texture.desc()});
    return {state_->add({.name = name,
                         .layout = layout,
                         .kind = State::Kind::imported,
                         .memory = {texture.name(), texture.id()}},
                        keep)};
}

TextureHandle RenderGraph::import_default_framebuffer(const char* name, glm::uvec2 size) {
    const std::uint32_t layout = state_->layout_index({.texture = {.format = GL_RGBA8, .size = size}});
    return {state_->add(
        {.name = name, .layout = layout, .kind = State::Kind::default_framebuffer, .memory = {}}, true)};
}

BufferHandle RenderGraph::import_buffer(const char* name, const gl::Buffer& buffer, bool keep) {
    const std::uint32_t layout = state_->layout_index({.texture = {}, .buffer_bytes = buffer.size()});
    return {state_->add(
        {.name = name, .layout = layout, .kind = State::Kind::imported, .memory = {buffer.name(), 0}}, keep)};
}

const gl::TextureDesc& RenderGraph::desc(TextureHandle handle) const {
    RAMBLA_ASSERT(handle.valid(), "only handles of this frame have a description");
    return state_->layout(handle.version).texture;
}

std::uint64_t RenderGraph::pool_bytes() const {
    return state_->pool.bytes();
}

TextureHandle PassBuilder::create_texture(const char* name, const gl::TextureDesc& desc) {
    RenderGraph::State& state = *graph_.state_;
    return {state.add({.name = name, .layout = state.layout_index({.texture = desc}), .memory = {}}, false)};
}

BufferHandle PassBuilder::create_buffer(const char* name, std::size_t bytes) {
    RenderGraph::State& state = *graph_.state_;
    const std::uint32_t layout =
        state.layout_index({.texture = {}, .buffer_bytes = std::max<std::size_t>(bytes, 1)});
    return {state.add({.name = name, .layout = layout, .memory = {}}, false)};
}

TextureHandle PassBuilder::read(TextureHandle texture) {
    return read(texture, graph::Use::sampled);
}

TextureHandle PassBuilder::read(TextureHandle texture, graph::Use use) {
    graph_.state_->recording.read(pass_, texture.version, use);
    return texture;
}

BufferHandle PassBuilder::read(BufferHandle buffer, graph::Use use) {
    graph_.state_->recording.read(pass_, buffer.version, use);
    return buffer;
}

TextureHandle PassBuilder::write_colour(std::uint32_t slot, TextureHandle texture, LoadOp load,
                                        glm::vec4 clear_value, std::uint32_t level) {
    RenderGraph::State& state = *graph_.state_;
    if (slot >= gl::k_max_colour_attachments)
        throw std::logic_error("render graph: no such colour attachment");
    const std::uint32_t made =
        state.recording.write(pass_, texture.version, graph::Use::attachment, load == LoadOp::load);
    state.passes[pass_].colours[slot] = {.version = made, .load = load, .level = level, .clear = clear_value};
    return {made};
}

TextureHandle PassBuilder::write_depth(TextureHandle texture, LoadOp load, float clear_value) {
    RenderGraph::State& state = *graph_.state_;
    const std::uint32_t made =
        state.recording.write(pass_, texture.version, graph::Use::attachment, load == LoadOp::load);
    state.passes[pass_].depth = {.version = made, .load = load, .level = 0, .clear = glm::vec4{clear_value}};
    return {made};
}

TextureHandle PassBuilder::test_depth(TextureHandle texture) {
    RenderGraph::State& state = *graph_.state_;
    state.recording.read(pass_, texture.version, graph::Use::attachment);
    state.passes[pass_].depth = {.version = texture.version, .load = LoadOp::load, .level = 0, .clear = {}};
    return texture;
}

TextureHandle PassBuilder::write_image(TextureHandle texture) {
    return {graph_.state_->recording.write(pass_, texture.version, graph::Use::image, true)};
}

BufferHandle PassBuilder::write_storage(BufferHandle buffer) {
    return {graph_.state_->recording.write(pass_, buffer.version, graph::Use::storage, true)};
}

void PassBuilder::side_effect() {
    graph_.state_->recording.passes[pass_].side_effect = true;
}

}  // namespace rambla::render
