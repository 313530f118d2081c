#include <algorithm>
#include <array>

#include "assets/assert.h"
#include "render/gl/state.h"
#include "render/graph/graph.h"
#include "render/graph/graph_state.h"

namespace rambla::render {

namespace {

GLbitfield barrier_bits(graph::UseMask uses) {
    struct Row {
        graph::Use use;
        GLbitfield bits;
    };
    constexpr std::array rows{
        Row{graph::Use::sampled, GL_TEXTURE_FETCH_BARRIER_BIT},
        Row{graph::Use::image, GL_SHADER_IMAGE_ACCESS_BARRIER_BIT},
        Row{graph::Use::attachment, GL_FRAMEBUFFER_BARRIER_BIT},
        Row{graph::Use::storage, GL_SHADER_STORAGE_BARRIER_BIT},
        Row{graph::Use::uniform, GL_UNIFORM_BARRIER_BIT},
        Row{graph::Use::indirect, GL_COMMAND_BARRIER_BIT},
        Row{graph::Use::vertex, GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT},
        Row{graph::Use::index, GL_ELEMENT_ARRAY_BARRIER_BIT},
        Row{graph::Use::transfer,
            GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT},
    };
    GLbitfield bits = 0;
    for (const Row& row : rows) {
        if ((uses & graph::mask_of(row.use)) != 0) bits |= row.bits;
    }
    return bits;
}

std::uint64_t layout_bytes(const graph::Layout& layout) {
    return layout.buffer_bytes != 0 ? layout.buffer_bytes : gl::storage_bytes(layout.texture);
}

std::uint64_t level_bytes(const gl::TextureDesc& desc, std::uint32_t level) {
    const glm::uvec2 size = glm::max(desc.size >> level, glm::uvec2{1});
    return std::uint64_t{size.x} * size.y * desc.layers * gl::bytes_per_texel(desc.format);
}

/// Groups a pass's calls for GPU debuggers, whatever way the pass is left.
class DebugGroup {
public:
    explicit DebugGroup(const char* name) { glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name); }
    ~DebugGroup() { glPopDebugGroup(); }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

using State = RenderGraph::State;

struct BoundTargets {
    GLuint framebuffer = 0;
    glm::uvec2 size{0};
    bool any = false;
};

BoundTargets find_targets(State& state, const State::PassInfo& pass) {
    BoundTargets bound;
    graph::FramebufferCache::Key key;
    gl::FramebufferDesc desc;
    bool is_default = false;
    const auto take = [&](const State::Target& target) {
        const State::ResourceInfo& info = state.info(target.version);
        bound.size = glm::max(state.layout(target.version).texture.size >> target.level, glm::uvec2{1});
        bound.any = true;
        is_default = is_default || info.kind == State::Kind::default_framebuffer;
        return info.memory;
    };
    for (std::size_t slot = 0; slot < pass.colours.size(); ++slot) {
        const State::Target& target = pass.colours[slot];
        if (target.version == graph::k_none) continue;
        const graph::Pool::Memory memory = take(target);
        key.colours[slot] = memory.id;
        key.levels[slot] = target.level;
        desc.colours[slot] = {memory.name, target.level};
    }
    if (pass.depth.version != graph::k_none) {
        const graph::Pool::Memory memory = take(pass.depth);
        key.depth = memory.id;
        desc.depth = {memory.name, 0};
    }
    if (bound.any && !is_default) bound.framebuffer = state.framebuffers.get(key, desc, pass.name);
    return bound;
}

void load_targets(const State& state, const State::PassInfo& pass, GLuint framebuffer) {
    for (std::size_t slot = 0; slot < pass.colours.size(); ++slot) {
        const State::Target& target = pass.colours[slot];
        if (target.version == graph::k_none) continue;
        if (target.load == LoadOp::clear && gl::is_integer(state.layout(target.version).texture.format)) {
            const glm::uvec4 clear{target.clear};
            glClearNamedFramebufferuiv(framebuffer, GL_COLOR, static_cast<GLint>(slot), &clear.x);
        } else if (target.load == LoadOp::clear) {
            glClearNamedFramebufferfv(framebuffer, GL_COLOR, static_cast<GLint>(slot), &target.clear.x);
        } else if (target.load == LoadOp::discard) {
            const auto point =
                framebuffer == 0 ? GLenum{GL_COLOR} : static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + slot);
            glInvalidateNamedFramebufferData(framebuffer, 1, &point);
        }
    }
    if (pass.depth.version == graph::k_none) return;
    if (pass.depth.load == LoadOp::clear) {
        glDepthMask(GL_TRUE);
        glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &pass.depth.clear.x);
        glDepthMask(GL_FALSE);
    } else if (pass.depth.load == LoadOp::discard) {
        constexpr GLenum point = GL_DEPTH_ATTACHMENT;
        glInvalidateNamedFramebufferData(framebuffer, 1, &point);
    }
}

std::uint64_t bytes_written(const State& state, const State::PassInfo& info, const graph::Pass& pass) {
    std::uint64_t sum = 0;
    for (std::uint32_t a = 0; a < pass.access_count; ++a) {
        const graph::Access& access = state.recording.accesses[pass.first_access + a];
        if (access.writes == graph::k_none) continue;
        const graph::Layout& layout = state.layout(access.writes);
        std::uint32_t level = 0;
        for (const State::Target& target : info.colours) {
            if (target.version == access.writes) level = target.level;
        }
        sum +=
            access.use == graph::Use::attachment ? level_bytes(layout.texture, level) : layout_bytes(layout);
    }
    return sum;
}

bool draws(const State::PassInfo& pass) {
    return pass.depth.version != graph::k_none ||
           std::any_of(pass.colours.begin(), pass.colours.end(),
                       [](const State::Target& target) { return target.version != graph::k_none; });
}

std::uint64_t memory_at(const State& state, std::uint32_t position) {
    std::uint64_t sum = 0;
    for (const graph::Lifetime& life : state.plan->lifetimes) {
        if (life.slot == graph::k_none || position < life.first || position > life.last) continue;
        sum += layout_bytes(state.layouts[state.plan->slot_layouts[life.slot]]);
    }
    return sum;
}

}  // namespace

void RenderGraph::execute(PassTimers timers) {
    State& state = *state_;
    state.plan = &state.planner.plan(state.recording);
    const graph::Plan& plan = *state.plan;
    state.pool.begin_frame();
    state.framebuffers.begin_frame();

    state.slots.clear();
    for (const std::uint32_t layout : plan.slot_layouts) {
        state.slots.push_back(state.pool.acquire(state.layouts[layout], "transient"));
    }
    for (std::size_t r = 0; r < state.resources.size(); ++r) {
        if (plan.lifetimes[r].slot != graph::k_none)
            state.resources[r].memory = state.slots[plan.lifetimes[r].slot];
    }

    state.timers.begin_frame(timers);
    PassContext context{*this};
    for (std::uint32_t position = 0; position < plan.order.size(); ++position) {
        const State::PassInfo& pass = state.passes[plan.order[position]];
        const graph::Pass& declared = state.recording.passes[plan.order[position]];
        const DebugGroup group{pass.name};
        state.timers.begin_pass(pass.name, draws(pass), bytes_written(state, pass, declared),
                                memory_at(state, position));
        if (plan.barriers[position] != 0) glMemoryBarrier(barrier_bits(plan.barriers[position]));
        gl::reset_state();
        const BoundTargets bound = find_targets(state, pass);
        if (bound.any) {
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound.framebuffer);
            glViewport(0, 0, static_cast<GLsizei>(bound.size.x), static_cast<GLsizei>(bound.size.y));
            // A window's framebuffer may or may not encode; the last shader has done it already.
            if (bound.framebuffer == 0) glDisable(GL_FRAMEBUFFER_SRGB);
            load_targets(state, pass, bound.framebuffer);
        }
        context.framebuffer_ = bound.framebuffer;
        context.size_ = bound.size;
        pass.callback(context);
        state.timers.end_pass();
    }
    gl::reset_state();
    state.timers.end_frame();
}

const FrameCost& RenderGraph::take_cost() {
    return state_->timers.take();
}

GLuint PassContext::texture(TextureHandle handle) const {
    RAMBLA_ASSERT(handle.valid(), "the pass declared what it reads");
    const GLuint name = graph_.state_->info(handle.version).memory.name;
    RAMBLA_ASSERT(name != 0, "a declared texture has memory while its pass runs");
    return name;
}

const gl::TextureDesc& PassContext::desc(TextureHandle handle) const {
    return graph_.desc(handle);
}

GLuint PassContext::buffer(BufferHandle handle) const {
    RAMBLA_ASSERT(handle.valid(), "the pass declared what it reads");
    return graph_.state_->info(handle.version).memory.name;
}

void PassContext::bind_texture(GLuint unit, TextureHandle handle, const gl::Sampler& sampler) const {
    glBindTextureUnit(unit, texture(handle));
    glBindSampler(unit, sampler.name());
}

void PassContext::copy_into_target(TextureHandle from) const {
    RAMBLA_ASSERT(desc(from).size == size_, "a copy neither scales nor leaves anything out");
    RenderGraph::State& state = *graph_.state_;
    const graph::Pool::Memory memory = state.info(from.version).memory;
    graph::FramebufferCache::Key key;
    gl::FramebufferDesc reader;
    key.colours[0] = memory.id;
    reader.colours[0] = {memory.name, 0};
    const auto width = static_cast<GLint>(size_.x);
    const auto height = static_cast<GLint>(size_.y);
    glBlitNamedFramebuffer(state.framebuffers.get(key, reader, "copied"), framebuffer_, 0, 0, width, height,
                           0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void PassContext::bind_no_vertices() const {
    graph_.state_->no_vertices.bind();
}

void PassContext::draw_full_screen() const {
    bind_no_vertices();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace rambla::render
