#include "render/gl/calls.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "render/gl/context.h"
#include "render/gl/query.h"

namespace rambla::render::gl {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream{file};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (auto match = std::sregex_iterator{text.begin(), text.end(), pattern};
         match != std::sregex_iterator{}; ++match) {
        found.insert((*match)[1]);
    }
    return found;
}

TEST(GlCalls, EveryFunctionThatTheRendererCallsIsCounted) {
    std::set<std::string> called;
    const std::regex call{R"(\b(gl[A-Z][A-Za-z0-9]*)\()"};
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{RAMBLA_SOURCE_DIR "/render"}) {
        const fs::path& file = entry.path();
        if (file.extension() == ".cpp" || file.extension() == ".h")
            called.merge(matches(text_of(file), call));
    }
    const std::set<std::string> counted =
        matches(text_of(RAMBLA_SOURCE_DIR "/render/gl/calls.cpp"), std::regex{R"(&(gl[A-Z][A-Za-z0-9]*))"});
    ASSERT_GT(called.size(), 80u);
    EXPECT_EQ(counted, called);
}

TEST(GlCalls, AreCountedByKindFromTheFirstOneOn) {
    const Context context{{}, true};
    const CallCounts before = calls();
    glEnable(GL_BLEND);
    glDisable(GL_BLEND);
    glUseProgram(0);
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 1'000'000'000);
    glDeleteSync(fence);
    glFinish();
    const CallCounts counts = calls() - before;
    EXPECT_EQ(counts[CallKind::state], 2u);
    EXPECT_EQ(counts[CallKind::bind], 1u);
    EXPECT_EQ(counts[CallKind::query], 2u) << "a fence and its end";
    EXPECT_EQ(counts[CallKind::poll], 1u);
    EXPECT_EQ(counts[CallKind::pace], 1u);
    EXPECT_EQ(counts[CallKind::wait], 1u);
    EXPECT_EQ(counts[CallKind::draw], 0u);
    EXPECT_EQ(counts.total(), 8u);
}

TEST(GlCalls, AResultThatIsTakenOnlyIfItIsThereIsNoWait) {
    const Context context{{}, true};
    const Query query{"stamp", GL_TIMESTAMP};
    glQueryCounter(query.name(), GL_TIMESTAMP);
    glFinish();
    const CallCounts before = calls();
    EXPECT_TRUE(query.result().has_value());
    EXPECT_EQ((calls() - before)[CallKind::wait], 0u);
    EXPECT_EQ((calls() - before)[CallKind::query], 1u);
    GLuint64 waited_for = 0;
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &waited_for);
    EXPECT_EQ((calls() - before)[CallKind::wait], 1u);
    EXPECT_EQ(query.result(), waited_for);
}

TEST(GlCalls, AnotherContextGoesOnCounting) {
    for (int i = 0; i < 2; ++i) {
        const Context context{{}, true};
        const CallCounts before = calls();
        glCullFace(GL_BACK);
        EXPECT_EQ((calls() - before)[CallKind::state], 1u);
    }
}

}  // namespace
}  // namespace rambla::render::gl
