#include "render/gl/shader_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "render/gl/program.h"
#include "unit/render/gl_fixture.h"

namespace rambla::render::gl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using Files = std::map<std::string, std::string>;

ShaderSource source_of(const Files& files) {
    return [&files](const std::string& path) {
        const auto found = files.find(path);
        if (found == files.end()) throw std::out_of_range("no such file");
        return found->second;
    };
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const ShaderError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(ShaderText, IncludesEachFileOnceUnderEitherFormOfItsName) {
    const Files files{{"main.glsl", "#include \"a.glsl\"\n#include \"b.glsl\"\nvoid main() {}\n"},
                      {"a.glsl", "  #  include \"b.glsl\"\nfloat a;\n"},
                      {"b.glsl", "#include \"render/shaders/a.glsl\"\nfloat b;\n"}};
    const ShaderText text = expand_shader("main.glsl", source_of(files), {});
    EXPECT_EQ(count(text.text, "float a;"), 1u);
    EXPECT_EQ(count(text.text, "float b;"), 1u);
    EXPECT_THAT(text.files, ElementsAre("(defines)", "main.glsl", "a.glsl", "b.glsl"));
}

TEST(ShaderText, PutsVersionThenDefinesInFront) {
    const Files files{{"main.glsl", "void main() {}\n"}};
    const ShaderText text = expand_shader("main.glsl", source_of(files), {{"TAPS", "16"}});
    EXPECT_TRUE(text.text.starts_with("#version 450 core\n"));
    EXPECT_LT(text.text.find("#define TAPS 16\n"), text.text.find("void main"));
}

TEST(ShaderText, BlanksTheIncludesOfCpp) {
    const Files files{{"main.glsl", "#include <glm/glm.hpp>\nvoid main() {}\n"}};
    EXPECT_THAT(expand_shader("main.glsl", source_of(files), {}).text, Not(HasSubstr("glm")));
}

TEST(ShaderText, NamesFileAndLineOfAMissingInclude) {
    const Files files{{"main.glsl", "\n#include \"a.glsl\"\n"}, {"a.glsl", "\n\n#include \"lost.glsl\"\n"}};
    const std::string message =
        message_of([&] { static_cast<void>(expand_shader("main.glsl", source_of(files), {})); });
    EXPECT_THAT(message, HasSubstr("a.glsl:3: cannot include \"lost.glsl\""));
    EXPECT_THAT(message, Not(HasSubstr("main.glsl:2")));
}

TEST(ShaderText, MapsTheLogsOfAllDrivers) {
    const Files files{{"main.glsl", "#include \"brdf.glsl\"\nvoid main() {}\n"},
                      {"brdf.glsl", "float f;\nfloat g;\n"}};
    const ShaderText text = expand_shader("main.glsl", source_of(files), {{"TAPS", "16"}});
    // Lines: version, extension, define, brdf 1, brdf 2, main 2.
    EXPECT_EQ(map_shader_log("0:5(5): error: no such thing", text), "brdf.glsl:2: error: no such thing");
    EXPECT_EQ(map_shader_log("0(6) : error C0000: syntax error", text),
              "main.glsl:2: error C0000: syntax error");
    EXPECT_EQ(map_shader_log("ERROR: 0:4: undeclared\nWARNING: 0:3: odd\n", text),
              "brdf.glsl:1: ERROR: undeclared\n(defines):3: WARNING: odd");
    EXPECT_EQ(map_shader_log("0:7(1): error: behind the end", text), "0:7(1): error: behind the end");
    EXPECT_EQ(map_shader_log("error: 3 uniforms too many", text), "error: 3 uniforms too many");
}

class Programs : public WithGl {};

TEST_F(Programs, NameFileAndLineOfAnErrorInAnIncludedFile) {
    const Files files{{"v.glsl", "#include \"f.glsl\"\nvoid main() { gl_Position = vec4(f()); }\n"},
                      {"f.glsl", "\nfloat f() {\n    return undeclared_name;\n}\n"},
                      {"p.glsl", "void main() {}\n"}};
    ProgramRegistry programs{source_of(files)};
    const std::string message = message_of([&] {
        static_cast<void>(programs.get(
            {.name = "test", .vertex = "v.glsl", .fragment = "p.glsl", .compute = {}, .defines = {}}));
    });
    EXPECT_THAT(message, HasSubstr("program test"));
    EXPECT_THAT(message, HasSubstr("f.glsl:3: "));
    EXPECT_THAT(message, HasSubstr("undeclared_name"));
}

TEST_F(Programs, CountLinesRightBehindAnInclude) {
    const Files files{{"v.glsl", "#include \"f.glsl\"\n\nvoid main() { gl_Position = vec4(wrong); }\n"},
                      {"f.glsl", "float f() {\n    return 1.0;\n}\n"},
                      {"p.glsl", "void main() {}\n"}};
    ProgramRegistry programs{source_of(files)};
    EXPECT_THAT(
        message_of([&] {
            static_cast<void>(programs.get(
                {.name = "test", .vertex = "v.glsl", .fragment = "p.glsl", .compute = {}, .defines = {}}));
        }),
        HasSubstr("v.glsl:3: "));
}

TEST_F(Programs, NameTheProgramThatDoesNotLink) {
    const Files files{{"v.glsl", "out vec2 a;\nvoid main() { a = vec2(1.0); gl_Position = vec4(0.0); }\n"},
                      {"p.glsl", "in vec4 a;\nout vec4 colour;\nvoid main() { colour = a; }\n"}};
    ProgramRegistry programs{source_of(files)};
    EXPECT_THAT(
        message_of([&] {
            static_cast<void>(programs.get(
                {.name = "odd", .vertex = "v.glsl", .fragment = "p.glsl", .compute = {}, .defines = {}}));
        }),
        HasSubstr("program odd (v.glsl, p.glsl) does not link"));
}

TEST_F(Programs, AreSharedByEqualDescriptionsOnly) {
    const Files files{{"v.glsl", "void main() { gl_Position = vec4(VALUE); }\n"},
                      {"p.glsl", "void main() {}\n"}};
    ProgramRegistry programs{source_of(files)};
    const ProgramDesc desc{
        .name = "test", .vertex = "v.glsl", .fragment = "p.glsl", .compute = {}, .defines = {{"VALUE", "1"}}};
    ProgramDesc other = desc;
    other.defines = {{"VALUE", "2"}};
    const Program& program = programs.get(desc);
    EXPECT_EQ(&program, &programs.get(desc));
    EXPECT_NE(&program, &programs.get(other));
    EXPECT_EQ(programs.list().size(), 2u);
}

TEST_F(Programs, ReloadOnlyWhatChangedAndSurviveAMistake) {
    Files files{{"v.glsl", "void main() { gl_Position = vec4(0.0); }\n"},
                {"w.glsl", "#include \"f.glsl\"\nvoid main() { gl_Position = vec4(f()); }\n"},
                {"f.glsl", "float f() { return 1.0; }\n"},
                {"p.glsl", "void main() {}\n"}};
    ProgramRegistry programs{source_of(files)};
    const Program& still = programs.get(
        {.name = "still", .vertex = "v.glsl", .fragment = "p.glsl", .compute = {}, .defines = {}});
    const Program& changing = programs.get(
        {.name = "changing", .vertex = "w.glsl", .fragment = "p.glsl", .compute = {}, .defines = {}});
    const GLuint still_name = still.name();
    const GLuint first_name = changing.name();
    EXPECT_EQ(programs.reload(), "");
    EXPECT_EQ(changing.name(), first_name) << "unchanged text is not compiled again";

    files["f.glsl"] = "float f() { return mistake; }\n";
    EXPECT_THAT(programs.reload(), HasSubstr("f.glsl:1: "));
    EXPECT_EQ(changing.name(), first_name) << "a mistake leaves the old program in use";

    files["f.glsl"] = "float f() { return 2.0; }\n";
    EXPECT_EQ(programs.reload(), "");
    EXPECT_NE(changing.name(), first_name);
    EXPECT_EQ(still.name(), still_name);
}

}  // namespace
}  // namespace rambla::render::gl
