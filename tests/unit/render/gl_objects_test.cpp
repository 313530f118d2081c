#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "render/gl/buffer.h"
#include "render/gl/context.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gl/query.h"
#include "render/gl/texture.h"
#include "render/gl/vertex_array.h"
#include "unit/render/gl_fixture.h"

namespace rambla::render::gl {
namespace {

using testing::HasSubstr;

class GlObjects : public WithGl {};

TEST_F(GlObjects, ReturnEveryObjectAndByte) {
    const LiveCounts before = live_counts();
    {
        const Buffer buffer{"buffer", 1000};
        const Texture texture{"texture", {.format = GL_RGBA16F, .size = {8, 4}, .levels = 4}};
        EXPECT_EQ(live_counts().bytes - before.bytes, 1000u + 8u * (32u + 8u + 2u + 1u));
        const Sampler sampler{"sampler", {}};
        const VertexArray vertices{"vertices"};
        const Query query{"query", GL_TIME_ELAPSED};
        FramebufferDesc desc;
        desc.colours[0] = {.texture = texture.name()};
        const Framebuffer framebuffer{"framebuffer", desc};
        const StreamBuffer stream{"stream", 100};
        EXPECT_EQ(live_counts().objects - before.objects, 7u);
    }
    EXPECT_EQ(live_counts().objects, before.objects);
    EXPECT_EQ(live_counts().bytes, before.bytes);
}

TEST_F(GlObjects, MoveWithoutBeingCountedTwice) {
    const LiveCounts before = live_counts();
    Buffer a{"a", 16};
    const GLuint name = a.name();
    Buffer b{std::move(a)};
    EXPECT_EQ(b.name(), name);
    EXPECT_EQ(live_counts().objects - before.objects, 1u);
    b = Buffer{"c", 32};
    EXPECT_EQ(live_counts().objects - before.objects, 1u);
    EXPECT_EQ(live_counts().bytes - before.bytes, 32u);
    EXPECT_FALSE(glIsBuffer(name)) << "what is assigned over is deleted";
}

TEST_F(GlObjects, CarryTheirLabels) {
    const Buffer buffer{"a label", 4};
    char text[32] = {};
    glGetObjectLabel(GL_BUFFER, buffer.name(), sizeof(text), nullptr, text);
    EXPECT_STREQ(text, "a label");
}

TEST_F(GlObjects, RefuseIncompleteFramebuffersByName) {
    const Texture colour{"colour", {.format = GL_RGBA8}};
    FramebufferDesc desc;
    desc.depth = {.texture = colour.name()};  // a colour format cannot be a depth attachment
    try {
        const Framebuffer framebuffer{"odd pass", desc};
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("odd pass"));
    }
    EXPECT_ANY_THROW(context_.check_errors()) << "the driver complains as well";
}

std::vector<std::uint32_t> read_back(const BufferRange& range) {
    std::vector<std::uint32_t> values(static_cast<std::size_t>(range.size) / sizeof(std::uint32_t));
    glGetNamedBufferSubData(range.buffer, range.offset, range.size, values.data());
    return values;
}

TEST_F(GlObjects, StreamBuffersGrowAndKeepTheFramesEarlierRanges) {
    StreamBuffer stream{"stream", 1};
    EXPECT_EQ(stream.bytes_per_frame(), StreamBuffer::k_alignment);
    std::vector<std::uint32_t> small(16);
    std::iota(small.begin(), small.end(), 7u);
    std::vector<std::uint32_t> large(10'000);
    std::iota(large.begin(), large.end(), 1000u);
    stream.begin_frame();
    const BufferRange first = stream.upload(std::span<const std::uint32_t>{small});
    const BufferRange second = stream.upload(std::span<const std::uint32_t>{large});
    EXPECT_NE(first.buffer, second.buffer);
    EXPECT_EQ(read_back(first), small) << "the outgrown buffer serves its frame to the end";
    EXPECT_EQ(read_back(second), large);
    stream.end_frame();
    EXPECT_FALSE(glIsBuffer(first.buffer));
    EXPECT_GE(stream.bytes_per_frame(), large.size() * sizeof(std::uint32_t));
}

TEST_F(GlObjects, StreamBuffersSettleAndKeepFramesInFlightApart) {
    StreamBuffer stream{"stream", 4096};
    const LiveCounts before = live_counts();
    std::vector<BufferRange> ranges;
    for (std::uint32_t frame = 0; frame < 2 * StreamBuffer::k_frames_in_flight; ++frame) {
        stream.begin_frame();
        ranges.push_back(stream.upload_value(frame));
        const BufferRange next = stream.upload_value(frame);
        EXPECT_EQ(next.offset % static_cast<GLintptr>(StreamBuffer::k_alignment), 0);
        stream.end_frame();
    }
    EXPECT_EQ(live_counts().objects, before.objects);
    for (std::size_t i = 0; i < StreamBuffer::k_frames_in_flight; ++i) {
        EXPECT_EQ(ranges[i].offset, ranges[i + StreamBuffer::k_frames_in_flight].offset);
        for (std::size_t j = i + 1; j < StreamBuffer::k_frames_in_flight; ++j) {
            EXPECT_NE(ranges[i].offset, ranges[j].offset);
        }
    }
}

TEST_F(GlObjects, ErrorsOfGlAreThrownWithTheDriversWords) {
    glEnable(GL_TEXTURE_2D);  // not an enum of the core profile
    EXPECT_THROW(context_.check_errors(), std::runtime_error);
    EXPECT_NO_THROW(context_.check_errors()) << "each error is reported once";
}

TEST(Device, IsDescribedForTheDoctor) {
    const DeviceInfo device = query_device({});
    EXPECT_FALSE(device.renderer.empty());
    EXPECT_FALSE(device.version.empty());
    EXPECT_FALSE(device.limits.empty());
    EXPECT_NO_THROW(require_features(device));
}

TEST(Device, WithoutARequiredFeatureIsRefusedByItsName) {
    DeviceInfo device;
    device.renderer = "Some GPU";
    device.version = "4.4";
    device.features = {{.name = "GL_optional", .present = false, .required = false},
                       {.name = "GL_needed", .present = false, .required = true}};
    try {
        require_features(device);
        FAIL() << "nothing was thrown";
    } catch (const MissingFeature& error) {
        EXPECT_THAT(error.what(), HasSubstr("GL_needed"));
        EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos) << "one line";
    }
}

TEST(Device, WithTooSmallALimitIsRefusedWithBothNumbers) {
    DeviceInfo device;
    device.limits = {{.name = "GL_MAX_THINGS", .value = 3, .required = 4}};
    try {
        require_features(device);
        FAIL() << "nothing was thrown";
    } catch (const MissingFeature& error) {
        EXPECT_THAT(error.what(), HasSubstr("GL_MAX_THINGS"));
        EXPECT_THAT(error.what(), HasSubstr("3"));
        EXPECT_THAT(error.what(), HasSubstr("4"));
    }
}

[[noreturn]] void open_context_of_old_driver() {
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    try {
        const Context context{WindowContext{}, true};
    } catch (const MissingFeature& error) {
        std::fprintf(stderr, "%s\n", error.what());
        std::_Exit(3);
    }
    std::_Exit(0);
}

// A process of its own, since Mesa reads the variable once.
TEST(DeviceDeathTest, OlderThan45IsRefusedByNameBeforeAnythingIsDrawn) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(open_context_of_old_driver(), testing::ExitedWithCode(3), "OpenGL 4.5 core profile");
}

TEST(ShaderSource, HoldsTheShadersAndNamesWhatItLacks) {
    EXPECT_THAT(embedded_shader("shared/instance.h"), HasSubstr("struct Instance"));
    try {
        static_cast<void>(embedded_shader("lost.glsl"));
        FAIL() << "nothing was thrown";
    } catch (const std::out_of_range& error) {
        EXPECT_THAT(error.what(), HasSubstr("lost.glsl"));
    }
}

}  // namespace
}  // namespace rambla::render::gl
