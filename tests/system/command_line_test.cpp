#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "system/pictures.h"
#include "system/program.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A square of two triangles that faces +Z, as a .gltf whose buffer lies in square.bin.
std::string square_gltf(const std::string& buffer, const std::string& material) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"material":0}]}],
"accessors":[
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"},
{"bufferView":3,"componentType":5123,"count":6,"type":"SCALAR"}],
"bufferViews":[
{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":48},
{"buffer":0,"byteOffset":96,"byteLength":32},{"buffer":0,"byteOffset":128,"byteLength":12}],
"buffers":[{"uri":")" +
           buffer + R"(","byteLength":140}],)" + material + "}";
}

std::string square_buffer() {
    const float floats[]{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 0, 1, 0,
                         0,  1,  0, 0, 1,  0, 0, 1, 0, 1,  1, 1, 1, 0, 0, 0};
    const std::uint16_t indices[]{0, 1, 2, 0, 2, 3};
    std::string bytes{reinterpret_cast<const char*>(floats), sizeof floats};
    bytes.append(reinterpret_cast<const char*>(indices), sizeof indices);
    return bytes;
}

const std::string k_plain = R"("materials":[{"doubleSided":true}])";
const std::string k_textured =
    R"("materials":[{"doubleSided":true,"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0}}],
"textures":[{"source":0}],"images":[{"uri":"wallpaper.png"}])";

struct CommandLineProgram : testing::Test {
    ScratchFolder scratch;
    fs::path folder = scratch.path();

    /// One line that names the culprit, and exit code 2.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& named) {
        const Ended ended = rambla(arguments, folder);
        EXPECT_EQ(ended.exit_code, 2) << ended.err;
        EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
        EXPECT_THAT(ended.err, HasSubstr(named));
        EXPECT_EQ(ended.out, "");
    }
};

TEST_F(CommandLineProgram, AMissingFileIsOneLine) {
    expect_refused({"view", "nowhere.glb", "--headless", "--out", "p.png"}, "nowhere.glb");
}

TEST_F(CommandLineProgram, ATruncatedGlbIsOneLine) {
    const Ended made =
        rambla({"generate", "city:blocks=1x1,walkers=1,cars=1", "-o", "city.glb", "--quiet"}, folder);
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const std::string whole = file_text(folder / "city.glb");
    ASSERT_GT(whole.size(), 1000u);
    for (const std::size_t kept :
         {std::size_t{0}, std::size_t{8}, std::size_t{15}, whole.size() / 2, whole.size() - 1}) {
        SCOPED_TRACE(kept);
        write_file(folder / "cut.glb", whole.substr(0, kept));
        expect_refused({"view", "cut.glb", "--headless", "--out", "p.png"}, "cut.glb");
    }
}

TEST_F(CommandLineProgram, ATextFileNamedGlbIsOneLine) {
    write_file(folder / "letter.glb", "Dear reader,\nthis is not a model.\n");
    expect_refused({"view", "letter.glb", "--headless", "--out", "p.png"}, "letter.glb");
}

TEST_F(CommandLineProgram, AMissingBufferIsOneLineThatNamesFileAndBuffer) {
    write_file(folder / "square.gltf", square_gltf("gone.bin", k_plain));
    expect_refused({"view", "square.gltf", "--headless", "--out", "p.png"}, "square.gltf");
    expect_refused({"view", "square.gltf", "--headless", "--out", "p.png"}, "gone.bin");
}

TEST_F(CommandLineProgram, WrongUsageIsOneLine) {
    expect_refused({}, "subcommand");
    expect_refused({"stroll"}, "stroll");
    expect_refused({"walk", "--nonsense"}, "--nonsense");
    expect_refused({"walk", "--frames", "many"}, "--frames");
    expect_refused({"walk", "--size", "960"}, "960");
    expect_refused({"walk", "--shadows", "focused:size=1"}, "256 to 8192");
    expect_refused({"walk", "--steps", "5"}, "--no-render");
    expect_refused({"walk", "--shadows", "focused:taps=5"}, "4, 16");
    expect_refused({"walk", "--tonemap", "aces:exposure=1"}, "exposure");
    expect_refused({"walk", "--scene", "moon"}, "moon");
    expect_refused({"walk", "--time", "25:00"}, "time is '25:00', expected noon, dusk, night or HH:MM");
    expect_refused({"play", "--time", "evening"}, "evening");
    expect_refused({"walk", "--scene", "blocks", "--time", "dusk"}, "19:55");
    expect_refused({"walk", "--scene", "agents:n=3"}, "no parameters");
    expect_refused({"walk", "--compare", "--aa", "none"}, "--aa");
    expect_refused({"walk", "--compare", "--no-render"}, "--compare");
    expect_refused({"walk", "--scene", "city:blocks=many"}, "blocks");
    expect_refused({"generate", "moon", "-o", "m.glb"}, "moon");
    expect_refused({"view"}, "file");
}

TEST_F(CommandLineProgram, ANumberBelowZeroIsOneLine) {
    expect_refused({"walk", "--no-render", "--steps", "-1"}, "--steps: found '-1'");
    expect_refused({"walk", "--seed", "-1"}, "--seed: found '-1'");
    expect_refused({"walk", "--frames", "-1"}, "--frames: found '-1'");
    expect_refused({"walk", "--profile-frames", "-1"}, "--profile-frames: found '-1'");
    expect_refused({"play", "--frames", "-1"}, "--frames: found '-1'");
    expect_refused({"view", "city.glb", "--frames", "-1"}, "--frames: found '-1'");
    expect_refused({"view", "city.glb", "--camera", "-1"}, "--camera: found '-1'");
    expect_refused({"generate", "city", "--seed", "-1", "-o", "c.glb"}, "--seed: found '-1'");
}

TEST_F(CommandLineProgram, AJsonFileThatCannotBeIsKnownBeforeTheWork) {
    write_file(folder / "letter", "not a folder");
    expect_refused({"generate", "city:blocks=1x1", "-o", "c.glb", "--json", "letter/c.json"},
                   "letter/c.json");
    EXPECT_FALSE(fs::exists(folder / "c.glb"));
    expect_refused({"walk", "--headless", "-o", "w", "--json", "."}, "cannot be written");
    EXPECT_FALSE(fs::exists(folder / "w"));
    EXPECT_EQ(file_text(folder / "letter"), "not a folder");
}

TEST_F(CommandLineProgram, ViewRefusesWhatItCannotDo) {
    write_file(folder / "square.bin", square_buffer());
    write_file(folder / "square.gltf", square_gltf("square.bin", k_plain));
    expect_refused({"view", "square.gltf", "--headless", "--frames", "3"}, "--headless");
    expect_refused({"view", "square.gltf", "--out", "p.png", "--frames", "3"}, "--out");
    expect_refused({"view", "square.gltf", "--headless", "--camera", "7"}, "square.gltf has none");
}

TEST_F(CommandLineProgram, AMissingTextureIsAWarningAndAVisiblePlaceholder) {
    write_file(folder / "square.bin", square_buffer());
    write_file(folder / "square.gltf", square_gltf("square.bin", k_textured));
    const Ended ended =
        rambla({"view", "square.gltf", "--headless", "--out", "p.png", "--size", "160x120"}, folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("wallpaper.png"));
    // The square fills a good part of the picture, and half of the checkerboard is magenta.
    EXPECT_GT(magenta_share(picture(folder / "p.png")), 0.05);
}

TEST_F(CommandLineProgram, AModelWithoutFlawsIsShownWithoutAWord) {
    write_file(folder / "square.bin", square_buffer());
    write_file(folder / "square.gltf", square_gltf("square.bin", k_plain));
    const Ended ended = rambla(
        {"view", "square.gltf", "--headless", "--out", "p.png", "--size", "160x120", "--quiet"}, folder);
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err, "");
    EXPECT_EQ(magenta_share(picture(folder / "p.png")), 0.0);
    EXPECT_EQ(picture(folder / "p.png").width, 160u);
}

TEST_F(CommandLineProgram, SeveralModelsBecomeASheetThatShowsWhatIsRefused) {
    write_file(folder / "square.bin", square_buffer());
    write_file(folder / "square.gltf", square_gltf("square.bin", k_plain));
    const Ended ended = rambla({"view", "square.gltf", "nowhere.glb", "square.gltf", "--headless", "--out",
                                "s.png", "--size", "160x120", "--json", "-", "--quiet"},
                               folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
    const nlohmann::json rows = nlohmann::json::parse(ended.out)["files"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0]["visible"], 1);
    EXPECT_FALSE(rows[0].contains("error"));
    EXPECT_THAT(rows[1]["error"].get<std::string>(), HasSubstr("nowhere.glb"));
    // Two by two cells with gaps of 4 pixels: the square in the first and the third, and in no other.
    const assets::Image sheet = picture(folder / "s.png");
    ASSERT_EQ(sheet.width, 2 * 160u + 3 * 4u);
    ASSERT_EQ(sheet.height, 2 * 120u + 3 * 4u);
    for (std::uint32_t y = 0; y < 120; ++y)
        for (std::uint32_t x = 0; x < 160; ++x)
            ASSERT_EQ(byte_at(sheet, 4 + x, 4 + y, 0), byte_at(sheet, 4 + x, 128 + y, 0)) << x << ' ' << y;
    EXPECT_EQ(byte_at(sheet, 168 + 80, 128 + 60, 0), 0) << "nothing lies in the fourth";
    EXPECT_NE(byte_at(sheet, 4 + 80, 4 + 60, 0), byte_at(sheet, 168 + 80, 4 + 60, 0));
    expect_refused({"view", "square.gltf", "square.gltf", "--headless", "--out", "s.exr"}, "s.exr");
    expect_refused({"view", "square.gltf", "square.gltf", "--frames", "3"}, "--frames");
}

TEST_F(CommandLineProgram, HelpIsCompleteAndGoesToStandardOutput) {
    const Ended all = rambla({"--help"}, folder);
    EXPECT_EQ(all.exit_code, 0);
    EXPECT_EQ(all.err, "");
    for (const char* const command : {"walk", "play", "view", "generate", "inspect", "doctor"}) {
        EXPECT_THAT(all.out, HasSubstr(command));
        const Ended one = rambla({command, "--help"}, folder);
        EXPECT_EQ(one.exit_code, 0) << command;
        EXPECT_THAT(one.out, HasSubstr("--json")) << command;
    }
    EXPECT_THAT(rambla({"play", "--help"}, folder).out, HasSubstr("F12"));
    EXPECT_THAT(rambla({"walk", "--help"}, folder).out, HasSubstr("256 to 8192 texels"));
}

TEST_F(CommandLineProgram, PlayWithoutADisplaySaysWhatToDo) {
    const Ended ended = rambla({"play"}, folder);
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("DISPLAY"));
    EXPECT_THAT(ended.err, HasSubstr("walk --headless"));
}

TEST_F(CommandLineProgram, DoctorKnowsTheDevice) {
    const Ended ended = rambla({"doctor", "--json", "-"}, folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json result = nlohmann::json::parse(ended.out);
    EXPECT_EQ(result["schema"], "rambla.doctor/1");
    EXPECT_TRUE(result["good"].get<bool>());
    EXPECT_THAT(result["version"].get<std::string>(), HasSubstr("4."));
    EXPECT_FALSE(result["features"].empty());
    EXPECT_FALSE(result["limits"].empty());
}

TEST_F(CommandLineProgram, DoctorTellsTheSchedule) {
    const Ended ended = rambla({"doctor", "--schedule", "--json", "-"}, folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json result = nlohmann::json::parse(ended.out);
    EXPECT_EQ(result["schema"], "rambla.schedule/1");
    ASSERT_EQ(result["schedules"].size(), 2u);
    EXPECT_EQ(result["schedules"][0]["name"], "simulation");
    EXPECT_THAT(rambla({"doctor", "--schedule"}, folder).out, HasSubstr("waits for actors"));
}

}  // namespace
}  // namespace rambla::system_test
