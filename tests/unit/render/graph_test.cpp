#include "render/graph/graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "render/gl/calls.h"
#include "render/gl/program.h"
#include "render/graph/pool.h"
#include "unit/render/gl_fixture.h"

namespace rambla::render {
namespace {

using testing::HasSubstr;

constexpr glm::uvec2 k_size{4, 2};

glm::vec4 first_texel(const gl::Texture& texture) {
    std::vector<glm::vec4> texels(std::size_t{texture.desc().size.x} * texture.desc().size.y);
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
    return texels.front();
}

class Graph : public WithGl {
protected:
    gl::Texture screen_{"screen", {.format = GL_RGBA32F, .size = k_size}};
    RenderGraph graph_;

    void copy(const PassContext& context, TextureHandle from, GLuint to) {
        glCopyImageSubData(context.texture(from), GL_TEXTURE_2D, 0, 0, 0, 0, to, GL_TEXTURE_2D, 0, 0, 0, 0,
                           static_cast<GLsizei>(k_size.x), static_cast<GLsizei>(k_size.y), 1);
    }
};

TEST_F(Graph, ClearsBindsAndHandsTexturesOn) {
    graph_.begin_frame();
    TextureHandle screen = graph_.import_texture("screen", screen_, true);
    TextureHandle drawn;
    glm::uvec2 seen{0};
    graph_.add_pass(
        "draw",
        [&](PassBuilder& pass) {
            drawn = pass.write_colour(0, pass.create_texture("drawn", {.format = GL_RGBA32F, .size = k_size}),
                                      LoadOp::clear, {0.25f, 0.5f, 0.75f, 1.0f});
        },
        [&seen](PassContext& context) {
            seen = context.size();
            GLint bound = 0;
            glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
            EXPECT_EQ(static_cast<GLuint>(bound), context.framebuffer());
        });
    graph_.add_pass(
        "show",
        [&](PassBuilder& pass) {
            pass.read(drawn, graph::Use::transfer);
            screen = pass.write_colour(0, screen, LoadOp::discard);
        },
        [this, drawn](PassContext& context) { copy(context, drawn, screen_.name()); });
    graph_.execute();
    EXPECT_EQ(seen, k_size);
    EXPECT_EQ(first_texel(screen_), glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
}

TEST_F(Graph, GivesNeitherCallsNorMemoryToAPassThatNobodyReads) {
    bool ran = false;
    graph_.begin_frame();
    graph_.add_pass(
        "unread",
        [&](PassBuilder& pass) {
            static_cast<void>(pass.write_colour(
                0, pass.create_texture("lost", {.format = GL_RGBA16F, .size = {64, 64}}), LoadOp::clear));
        },
        [&ran](PassContext&) { ran = true; });
    const gl::LiveCounts before = gl::live_counts();
    graph_.execute();
    EXPECT_FALSE(ran);
    EXPECT_EQ(graph_.pool_bytes(), 0u);
    EXPECT_EQ(gl::live_counts().objects, before.objects);
    EXPECT_TRUE(graph_.take_cost().passes.empty());
}

/// A chain of `length` full targets, each made from the one before; returns their GL names.
std::vector<GLuint> run_chain(RenderGraph& graph, const gl::Texture& screen_texture, int length,
                              PassTimers timers = PassTimers::off) {
    std::vector<GLuint> names;
    graph.begin_frame();
    TextureHandle screen = graph.import_texture("screen", screen_texture, true);
    TextureHandle last;
    for (int i = 0; i < length; ++i) {
        TextureHandle made;
        graph.add_pass(
            "link",
            [&](PassBuilder& pass) {
                if (last.valid()) pass.read(last);
                made = pass.write_colour(
                    0, pass.create_texture("link", {.format = GL_RGBA16F, .size = {32, 32}}), LoadOp::clear);
            },
            [](PassContext&) {});
        last = made;
        graph.add_pass(
            "probe",
            [&](PassBuilder& pass) {
                pass.read(made);
                pass.side_effect();
            },
            [&names, made](PassContext& context) { names.push_back(context.texture(made)); });
    }
    graph.add_pass(
        "show",
        [&](PassBuilder& pass) {
            pass.read(last);
            screen = pass.write_colour(0, screen, LoadOp::clear);
        },
        [](PassContext&) {});
    graph.execute(timers);
    return names;
}

TEST_F(Graph, LetsTransientTexturesShareMemory) {
    const std::vector<GLuint> names = run_chain(graph_, screen_, 4);
    EXPECT_EQ(graph_.pool_bytes(), 2u * 32u * 32u * 8u) << "a chain needs its source and its target, no more";
    EXPECT_EQ(names[0], names[2]);
    EXPECT_EQ(names[1], names[3]);
    EXPECT_NE(names[0], names[1]);
}

TEST_F(Graph, MakesNothingNewInASteadyFrame) {
    static_cast<void>(run_chain(graph_, screen_, 4));
    const gl::LiveCounts before = gl::live_counts();
    for (int frame = 0; frame < 20; ++frame)
        static_cast<void>(run_chain(graph_, screen_, 4));
    EXPECT_EQ(gl::live_counts().objects, before.objects);
    EXPECT_EQ(gl::live_counts().bytes, before.bytes);
}

TEST_F(Graph, ReturnsMemoryToTheByteWhenAnEffectIsSwitchedOff) {
    static_cast<void>(run_chain(graph_, screen_, 1));
    const gl::LiveCounts before = gl::live_counts();
    for (int frame = 0; frame < 3; ++frame)
        static_cast<void>(run_chain(graph_, screen_, 2));
    EXPECT_GT(gl::live_counts().bytes, before.bytes);
    for (std::uint32_t frame = 0; frame <= graph::k_idle_frames + 1; ++frame) {
        static_cast<void>(run_chain(graph_, screen_, 1));
    }
    EXPECT_EQ(gl::live_counts().bytes, before.bytes);
    EXPECT_EQ(gl::live_counts().objects, before.objects);
}

// A driver may hand out the GL name of a deleted texture again: names alone would find the old framebuffer.
TEST_F(Graph, TellsTexturesOfOneNameApart) {
    graph::FramebufferCache cache;
    gl::FramebufferDesc desc;
    desc.colours[0] = {.texture = screen_.name()};
    graph::FramebufferCache::Key key;
    key.colours[0] = 1;
    const GLuint first = cache.get(key, desc, "first");
    EXPECT_EQ(cache.get(key, desc, "first"), first);
    key.colours[0] = 2;
    EXPECT_NE(cache.get(key, desc, "second"), first);
}

TEST_F(Graph, CountsTheBytesThatAttachmentsMayWrite) {
    graph_.begin_frame();
    TextureHandle screen = graph_.import_texture("screen", screen_, true);
    graph_.add_pass(
        "two targets",
        [&](PassBuilder& pass) {
            screen = pass.write_colour(0, screen, LoadOp::clear);
            static_cast<void>(pass.write_depth(
                pass.create_texture("depth", {.format = GL_DEPTH_COMPONENT32F, .size = k_size}),
                LoadOp::clear));
        },
        [](PassContext&) {});
    graph_.execute();
    const FrameCost& cost = graph_.take_cost();
    ASSERT_EQ(cost.passes.size(), 1u);
    EXPECT_EQ(cost.passes[0].bytes_written, k_size.x * k_size.y * (16u + 4u));
    EXPECT_EQ(cost.passes[0].memory_bytes, k_size.x * k_size.y * 4u) << "the screen is not the graph's";
}

TEST_F(Graph, TimesPassesOnlyWhenProfiled) {
    static_cast<void>(run_chain(graph_, screen_, 2));
    EXPECT_EQ(graph_.take_cost().gpu_ms, 0.0);
    static_cast<void>(run_chain(graph_, screen_, 2, PassTimers::alone));
    glFinish();
    const FrameCost& cost = graph_.take_cost();
    EXPECT_GT(cost.gpu_ms, 0.0);
    double sum = 0.0;
    for (const PassCost& pass : cost.passes)
        sum += pass.gpu_ms;
    EXPECT_GT(sum, 0.0);
    EXPECT_LE(sum, cost.gpu_ms) << "passes follow each other inside the envelope";
}

TEST_F(Graph, TellsWhereInTimePassesRanWithoutWaitingForThem) {
    using Clock = std::chrono::steady_clock;
    static_cast<void>(run_chain(graph_, screen_, 2, PassTimers::stamped));  // makes the queries
    glFinish();
    static_cast<void>(graph_.take_cost());
    const gl::CallCounts before = gl::calls();
    const Clock::time_point begin = Clock::now();
    static_cast<void>(run_chain(graph_, screen_, 2, PassTimers::stamped));
    const Clock::time_point submitted = Clock::now();
    EXPECT_EQ((gl::calls() - before)[gl::CallKind::wait], 0u);
    glFinish();
    const Clock::time_point end = Clock::now();
    const FrameCost& cost = graph_.take_cost();
    // Reading two clocks one after the other errs by less than this, unless the thread is put aside between.
    constexpr std::chrono::milliseconds k_error{1};
    const auto after = [](Clock::time_point from, double ms) {
        return from + std::chrono::nanoseconds{std::llround(1e6 * ms)};
    };
    EXPECT_GE(cost.gpu_begin, begin - k_error);
    EXPECT_LE(after(cost.gpu_begin, cost.gpu_ms), end + k_error);
    ASSERT_EQ(cost.passes.size(), 5u);
    Clock::time_point gpu = cost.gpu_begin;
    Clock::time_point cpu = begin;
    for (const PassCost& pass : cost.passes) {
        EXPECT_GE(pass.cpu_begin, cpu) << pass.name;
        EXPECT_GE(pass.gpu_begin, gpu) << pass.name << ": passes do not overlap";
        cpu = after(pass.cpu_begin, pass.cpu_ms);
        gpu = after(pass.gpu_begin, pass.gpu_ms);
    }
    EXPECT_LE(cpu, submitted);
    EXPECT_LE(gpu, after(cost.gpu_begin, cost.gpu_ms));
}

TEST_F(Graph, TellsPassesWithTheSameTargetApart) {
    gl::ProgramRegistry programs{[](const std::string& path) -> std::string {
        if (path == "corner.glsl") {
            return "void main() { gl_Position = vec4(4.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0,"
                   " 0.0, 1.0); }\n";
        }
        return "layout(location = 0) out vec4 colour;\n"
               "void main() { float x = gl_FragCoord.x;\n"
               "for (int i = 0; i < 200; ++i) x = sin(x);\n"
               "colour = vec4(x); }\n";
    }};
    const gl::Program& slow = programs.get(
        {.name = "slow", .vertex = "corner.glsl", .fragment = "slow.glsl", .compute = {}, .defines = {}});
    // Several tiles of llvmpipe's 64x64: in one alone, stamps are taken where they stand even without a
    // flush.
    const gl::Texture large{"large", {.format = GL_RGBA32F, .size = {192, 192}}};
    for (int frame = 0; frame < 2; ++frame) {
        graph_.begin_frame();
        TextureHandle screen = graph_.import_texture("screen", large, true);
        graph_.add_pass(
            "clear", [&](PassBuilder& pass) { screen = pass.write_colour(0, screen, LoadOp::clear); },
            [](PassContext&) {});
        graph_.add_pass(
            "slow", [&](PassBuilder& pass) { screen = pass.write_colour(0, screen, LoadOp::load); },
            [&slow](PassContext& context) {
                slow.use();
                context.draw_full_screen();
            });
        graph_.execute(PassTimers::stamped);
        glFinish();
        const FrameCost& cost = graph_.take_cost();
        if (frame == 0) continue;  // compiles
        ASSERT_EQ(cost.passes.size(), 2u);
        // A clear takes microseconds, seven million sines many milliseconds. Stamps that are not flushed are
        // taken in the last tile, where all others are done: the clear then has most of the time.
        EXPECT_GT(cost.passes[1].gpu_ms, 0.8 * cost.gpu_ms);
    }
}

TEST_F(Graph, MakesStorageWritesVisibleToReaders) {
    gl::ProgramRegistry programs{[](const std::string& path) -> std::string {
        if (path == "fill.glsl") {
            return "layout(local_size_x = 64) in;\n"
                   "layout(std430, binding = 0) buffer Values { uint values[]; };\n"
                   "void main() { values[gl_GlobalInvocationID.x] = 3u * gl_GlobalInvocationID.x; }\n";
        }
        return "layout(local_size_x = 64) in;\n"
               "layout(std430, binding = 0) readonly buffer Values { uint values[]; };\n"
               "layout(rgba32f, binding = 0) uniform writeonly image2D target;\n"
               "void main() { if (gl_GlobalInvocationID.x == 0u) imageStore(target, ivec2(0),"
               " vec4(values[63], values[1], 0.0, 1.0)); }\n";
    }};
    const gl::Program& fill =
        programs.get({.name = "fill", .vertex = {}, .fragment = {}, .compute = "fill.glsl", .defines = {}});
    const gl::Program& show =
        programs.get({.name = "show", .vertex = {}, .fragment = {}, .compute = "show.glsl", .defines = {}});
    graph_.begin_frame();
    TextureHandle screen = graph_.import_texture("screen", screen_, true);
    BufferHandle values;
    graph_.add_pass(
        "fill", [&](PassBuilder& pass) { values = pass.write_storage(pass.create_buffer("values", 64 * 4)); },
        [&fill, &values](PassContext& context) {
            fill.use();
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, context.buffer(values));
            glDispatchCompute(1, 1, 1);
        });
    graph_.add_pass(
        "show",
        [&](PassBuilder& pass) {
            pass.read(values, graph::Use::storage);
            screen = pass.write_image(screen);
        },
        [&show, &values, &screen](PassContext& context) {
            show.use();
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, context.buffer(values));
            glBindImageTexture(0, context.texture(screen), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
            glDispatchCompute(1, 1, 1);
        });
    graph_.execute();
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    EXPECT_EQ(first_texel(screen_), glm::vec4(189.0f, 3.0f, 0.0f, 1.0f));
}

TEST_F(Graph, DrawsItselfWithCulledPassesDashed) {
    graph_.begin_frame();
    TextureHandle screen = graph_.import_texture("screen", screen_, true);
    graph_.add_pass(
        "first & last", [&](PassBuilder& pass) { screen = pass.write_colour(0, screen, LoadOp::clear); },
        [](PassContext&) {});
    graph_.add_pass(
        "unread",
        [&](PassBuilder& pass) {
            static_cast<void>(pass.write_colour(0, pass.create_texture("lost", {}), LoadOp::clear));
        },
        [](PassContext&) {});
    graph_.execute();
    const std::string svg = graph_.svg();
    EXPECT_THAT(svg, testing::StartsWith("<svg"));
    EXPECT_THAT(svg, HasSubstr("first &amp; last"));
    EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
    EXPECT_LT(svg.find("first &amp; last"), svg.find("unread"));
}

}  // namespace
}  // namespace rambla::render
