#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "system/program.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// One triangle, whose buffer is a data URI of (0,0,0), (1,0,0), (0,1,0).
const std::string k_triangle =
    R"({"asset":{"version":"2.0","generator":"by hand"},"scenes":[{"name":"all","nodes":[0]}],
"extensionsUsed":["KHR_materials_unlit","VENDOR_wonder"],
"nodes":[{"name":"leaf","mesh":0}],"materials":[{"name":"plain","extensions":{"KHR_materials_unlit":{}}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

struct InspectCommand : testing::Test {
    ScratchFolder scratch;
    fs::path folder = scratch.path();
};

TEST_F(InspectCommand, TellsWhatAGltfFileHolds) {
    write_file(folder / "leaf.gltf", k_triangle);
    const Ended ended = rambla({"inspect", "leaf.gltf", "--json", "leaf.json"}, folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    for (const char* const expected : {"by hand", "VENDOR_wonder", "nodes (1)", "leaf", "plain", "36 B",
                                       "warnings (1)", "is not supported and ignored"})
        EXPECT_THAT(ended.out, HasSubstr(expected));
    EXPECT_EQ(ended.err, "") << "the warning is part of the result";
    const nlohmann::json result = nlohmann::json::parse(file_text(folder / "leaf.json"));
    EXPECT_EQ(result["schema"], "rambla.inspect/1");
    EXPECT_EQ(result["totals"]["triangles_of_all_nodes"], 1);
    EXPECT_EQ(result["totals"]["buffer_bytes"], 36);
    EXPECT_EQ(result["totals"]["document_bytes"], k_triangle.size());
    EXPECT_EQ(result["extensions_ignored"], nlohmann::json::array({"VENDOR_wonder"}));
    EXPECT_EQ(result["warnings"].size(), 1u);
}

TEST_F(InspectCommand, StandardOutputIsOneJsonObjectWhereItIsAskedFor) {
    write_file(folder / "leaf.gltf", k_triangle);
    const Ended ended = rambla({"inspect", "leaf.gltf", "--json", "-"}, folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(nlohmann::json::parse(ended.out)["meshes"].size(), 1u);
    EXPECT_THAT(ended.err, HasSubstr("meshes (1)"));
}

TEST_F(InspectCommand, TellsWhatAPictureIs) {
    // A 2 x 1 grey Targa (type 3, 8 bit, origin at the top).
    const char header[]{0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0x20};
    write_file(folder / "grey.tga", std::string{header, sizeof header} + "ab");
    const Ended ended = rambla({"inspect", "grey.tga", "--json", "-"}, folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json result = nlohmann::json::parse(ended.out);
    EXPECT_EQ(result["kind"], "picture");
    EXPECT_EQ(result["encoding"], "targa");
    EXPECT_EQ(result["width_px"], 2);
    EXPECT_EQ(result["height_px"], 1);
    EXPECT_EQ(result["channels"].size(), 1u);
    EXPECT_EQ(result["sample"], "uint8");
    EXPECT_EQ(result["file_bytes"], 20);
    EXPECT_THAT(ended.err, HasSubstr("2 x 1"));
}

TEST_F(InspectCommand, SeveralFilesAreATableThatHasTheRefusedToo) {
    write_file(folder / "leaf.gltf", k_triangle);
    write_file(folder / "cut, short.gltf", k_triangle.substr(0, 200));
    const Ended ended = rambla(
        {"inspect", "leaf.gltf", "cut, short.gltf", "nowhere.glb", "--csv", "t.csv", "--json", "t.json"},
        folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    EXPECT_THAT(ended.out, HasSubstr("0 load, 1 load with warnings, 2 are refused"));
    EXPECT_THAT(ended.out, HasSubstr("VENDOR_wonder"));
    const nlohmann::json rows = nlohmann::json::parse(file_text(folder / "t.json"))["files"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0]["result"], "warn");
    EXPECT_EQ(rows[0]["triangles"], 1);
    EXPECT_EQ(rows[0]["meshes"], 1);
    EXPECT_EQ(rows[1]["result"], "refuse");
    EXPECT_TRUE(rows[1]["triangles"].is_null());
    EXPECT_THAT(rows[2]["words"].get<std::string>(), HasSubstr("nowhere.glb"));
    const std::string csv = file_text(folder / "t.csv");
    EXPECT_EQ(line_count(csv), 4u) << csv;
    EXPECT_THAT(csv, HasSubstr("file,result,meshes,triangles,skins,clips,"));
    EXPECT_THAT(csv, HasSubstr("\nleaf.gltf,warn,1,1,0,0,1,1,0,0,0,"));
    EXPECT_THAT(csv, HasSubstr("\n\"cut, short.gltf\",refuse,,,,,,,,,,,\""));
    EXPECT_EQ(rambla({"inspect", "cut, short.gltf", "nowhere.glb"}, folder).exit_code, 2);
    EXPECT_EQ(rambla({"view", "cut, short.gltf", "nowhere.glb", "--out", "sheet.png"}, folder).exit_code, 2);
    EXPECT_EQ(rambla({"view", "leaf.gltf", "nowhere.glb", "--out", "sheet.png"}, folder).exit_code, 0);
}

TEST_F(InspectCommand, ABadFileIsOneLineAndExitCodeTwo) {
    write_file(folder / "letter.txt", "Dear reader,\n");
    write_file(folder / "cut.gltf", k_triangle.substr(0, 200));
    const char picture[]{0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 9, 0, 8, 0x20};
    write_file(folder / "cut.tga", std::string{picture, sizeof picture} + "ab");
    for (const char* const file : {"letter.txt", "cut.gltf", "cut.tga", "nowhere.glb", "nowhere.png"}) {
        const Ended ended = rambla({"inspect", file, "--json", "-"}, folder);
        EXPECT_EQ(ended.exit_code, 2) << file << ": " << ended.err;
        EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
        EXPECT_THAT(ended.err, HasSubstr(file));
        const nlohmann::json result = nlohmann::json::parse(ended.out);
        EXPECT_EQ(result["file"], file);
        EXPECT_THAT(ended.err, HasSubstr(result["error"].get<std::string>()));
    }
}

}  // namespace
}  // namespace rambla::system_test
