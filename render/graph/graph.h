#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "render/gl/buffer.h"
#include "render/gl/texture.h"
#include "render/graph/callback.h"
#include "render/graph/cost.h"
#include "render/graph/plan.h"

namespace rambla::render {

/// A texture of the graph in one state of its contents: each write makes a new handle, and whoever reads a
/// handle reads what that write left.
struct TextureHandle {
    std::uint32_t version = graph::k_none;
    [[nodiscard]] bool valid() const { return version != graph::k_none; }
};

/// The same for a buffer.
struct BufferHandle {
    std::uint32_t version = graph::k_none;
    [[nodiscard]] bool valid() const { return version != graph::k_none; }
};

/// What an attachment holds when its pass begins.
enum class LoadOp : std::uint8_t {
    load,    ///< what the handle's last writer left
    clear,   ///< the clear value
    discard  ///< anything: the pass writes every pixel that is read later
};

class RenderGraph;

/// What a pass declares in its set-up step. Names must be literals: the graph keeps the pointers.
class PassBuilder {
public:
    /// A transient texture, alive from its first writer to its last reader.
    [[nodiscard]] TextureHandle create_texture(const char* name, const gl::TextureDesc& desc);
    [[nodiscard]] BufferHandle create_buffer(const char* name, std::size_t bytes);

    /// Sampled or fetched in shaders. Returns the handle for convenience.
    TextureHandle read(TextureHandle texture);
    /// Read as image, shader storage, uniform block, indirect commands or vertices (see graph::Use).
    TextureHandle read(TextureHandle texture, graph::Use use);
    BufferHandle read(BufferHandle buffer, graph::Use use);

    /// Drawn into as colour attachment `slot`. @return  the texture as this pass leaves it
    [[nodiscard]] TextureHandle write_colour(std::uint32_t slot, TextureHandle texture, LoadOp load,
                                             glm::vec4 clear_value = glm::vec4{0.0f},
                                             std::uint32_t level = 0);
    /// Drawn into as depth attachment. The clear value suits reversed Z: infinitely far.
    [[nodiscard]] TextureHandle write_depth(TextureHandle texture, LoadOp load, float clear_value = 0.0f);
    /// Tested against but not written; the pass may sample it as well.
    TextureHandle test_depth(TextureHandle texture);

    /// Written by image stores or as shader storage: later readers get the barrier that their use needs.
    [[nodiscard]] TextureHandle write_image(TextureHandle texture);
    [[nodiscard]] BufferHandle write_storage(BufferHandle buffer);

    /// Never culled, though nobody in the graph reads what it does (read-backs).
    void side_effect();

private:
    friend class RenderGraph;
    PassBuilder(RenderGraph& owner, std::uint32_t index) : graph_{owner}, pass_{index} {}
    RenderGraph& graph_;
    std::uint32_t pass_;
};

/// What a pass's callback works with. Its framebuffer is bound, the viewport covers it, attachments are
/// cleared, and the GL state is the graph's default: no depth test or write, no culling, no blending, no
/// scissor, all colour writes.
class PassContext {
public:
    /// GL name of a texture that the pass declared.
    [[nodiscard]] GLuint texture(TextureHandle handle) const;
    [[nodiscard]] const gl::TextureDesc& desc(TextureHandle handle) const;
    [[nodiscard]] GLuint buffer(BufferHandle handle) const;
    /// GL name of the bound framebuffer.
    [[nodiscard]] GLuint framebuffer() const { return framebuffer_; }
    /// Size of the attachments.
    [[nodiscard]] glm::uvec2 size() const { return size_; }

    /// Binds a texture and a sampler to a unit.
    void bind_texture(GLuint unit, TextureHandle handle, const gl::Sampler& sampler) const;
    /// Copies a colour texture of the attachments' size, which the pass reads for a transfer, into colour
    /// attachment 0.
    void copy_into_target(TextureHandle from) const;
    /// Binds a vertex array without attributes, for draws that make their vertices from gl_VertexID.
    void bind_no_vertices() const;
    /// Draws one triangle that covers the viewport; the vertex shader makes it from gl_VertexID 0…2.
    void draw_full_screen() const;

private:
    friend class RenderGraph;
    explicit PassContext(const RenderGraph& owner) : graph_{owner} {}
    const RenderGraph& graph_;
    GLuint framebuffer_ = 0;
    glm::uvec2 size_{0};
};

/// The frame as passes with declared reads and writes. Filled anew each frame, it orders the passes, leaves
/// out those whose outputs nobody reads, gives transient textures memory from a pool in which lifetimes share
/// it, inserts memory barriers, and runs and times the callbacks. A steady frame allocates nothing.
class RenderGraph {
public:
    RenderGraph();
    ~RenderGraph();
    struct State;  ///< for the graph's own files
    RenderGraph(const RenderGraph&) = delete;
    RenderGraph& operator=(const RenderGraph&) = delete;

    /// Forgets the passes of the frame before; pooled textures stay.
    void begin_frame();

    /// Adds a pass: `setup(PassBuilder&)` runs at once, `execute(PassContext&)` in execute(). `execute` must
    /// be trivially copyable: capture handles by value and long-lived objects by reference.
    template <class Setup, class Execute>
    void add_pass(const char* name, Setup&& setup, Execute&& execute) {
        PassBuilder builder{*this, new_pass(name)};
        setup(builder);
        set_callback(builder.pass_, graph::Callback<PassContext&>{execute});
    }

    /// A texture that outlives the frame. What is written to it is kept: such writers are culled only when
    /// nobody reads them and `keep` is false.
    [[nodiscard]] TextureHandle import_texture(const char* name, const gl::Texture& texture, bool keep);
    /// The window's own framebuffer: can be drawn into as colour attachment 0, alone; never culled.
    [[nodiscard]] TextureHandle import_default_framebuffer(const char* name, glm::uvec2 size);
    [[nodiscard]] BufferHandle import_buffer(const char* name, const gl::Buffer& buffer, bool keep);

    [[nodiscard]] const gl::TextureDesc& desc(TextureHandle handle) const;

    /// Runs the frame. @param timers  whether and how each pass is timed on the GPU
    void execute(PassTimers timers = PassTimers::off);

    /// Costs of the oldest executed frame not yet taken. Never waits, so call it when that frame's fence has
    /// passed: what the GPU has not done yet counts as not timed. The reference is valid until the next call.
    [[nodiscard]] const FrameCost& take_cost();

    /// The last executed frame as an SVG drawing: passes are columns in the order in which they ran (culled
    /// ones last, dashed), resources rows with a dot per write, a ring per read and a bar for the time they
    /// hold memory.
    [[nodiscard]] std::string svg() const;

    /// Bytes that the pool holds now.
    [[nodiscard]] std::uint64_t pool_bytes() const;

private:
    friend class PassBuilder;
    friend class PassContext;
    [[nodiscard]] std::uint32_t new_pass(const char* name);
    void set_callback(std::uint32_t pass, graph::Callback<PassContext&> callback);

    std::unique_ptr<State> state_;
};

}  // namespace rambla::render
