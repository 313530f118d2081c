#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "assets/process/tangents.h"
#include "import_support.h"
#include "support/scene_check.h"

namespace rambla::assets::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<fs::path> gltf_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
        if (const fs::path extension = entry.path().extension(); extension == ".gltf" || extension == ".glb")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find('\n') == std::string::npos;
}

struct Counts {
    std::size_t meshes = 0, triangles = 0, skins = 0, clips = 0;
    bool operator==(const Counts&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Counts& counts) {
    return out << counts.meshes << " meshes, " << counts.triangles << " triangles, " << counts.skins
               << " skins, " << counts.clips << " clips";
}

/// Each model counts once, however many nodes show it.
Counts counts_of(const Scene& scene) {
    Counts counts{.meshes = scene.meshes.size(),
                  .triangles = 0,
                  .skins = scene.skeletons.size(),
                  .clips = scene.clips.size()};
    for (const Model& model : scene.models)
        for (const ModelPart& part : model.parts)
            if (scene.meshes[part.mesh].topology == Topology::triangles)
                counts.triangles += scene.meshes[part.mesh].indices.size() / 3;
    return counts;
}

std::vector<std::string> words(const std::string& line, char separator) {
    std::vector<std::string> out;
    std::string word;
    for (std::istringstream in{line}; std::getline(in, word, separator);)
        out.push_back(word);
    return out;
}

/// Cells of a line of a table; one in quotes may hold commas.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) cells.emplace_back();
        if (c != '"' && (c != ',' || quoted)) cells.back().push_back(c);
    }
    return cells;
}

/// A table with a head line: by first cell, the other cells by the head.
using Table = std::map<std::string, std::map<std::string, std::string>>;

Table read_table(const fs::path& file) {
    std::ifstream in{file};
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> head = cells_of(line);
    Table table;
    while (std::getline(in, line)) {
        const std::vector<std::string> cells = cells_of(line);
        EXPECT_EQ(cells.size(), head.size()) << file << ": " << line;
        for (std::size_t c = 1; c < std::min(cells.size(), head.size()); ++c)
            EXPECT_TRUE(table[cells[0]].emplace(head[c], cells[c]).second) << cells[0] << " stands twice";
    }
    return table;
}

/// What each file of the corpus must do, in tests/unit/assets/expected.csv:
/// - result: load (without a word), warn, or refuse,
/// - words: of the error, all of them; of the warnings, one of each; separated by semicolons,
/// - counts that the importer gives, for files that load,
/// - note: why a count or the result differs from what MANIFEST.csv and README.md of the corpus say.
Table expected_table() {
    return read_table(fs::path{RAMBLA_SOURCE_DIR} / "tests/unit/assets/expected.csv");
}

Counts counts_in(const std::map<std::string, std::string>& row) {
    return {.meshes = std::stoul(row.at("meshes")),
            .triangles = std::stoul(row.at("triangles")),
            .skins = std::stoul(row.at("skins")),
            .clips = std::stoul(row.at("clips"))};
}

void expect_refusal(const fs::path& file, const std::map<std::string, std::string>& row) {
    const std::string error = import_error(file);
    EXPECT_TRUE(is_one_line(error)) << file << ": " << error;
    EXPECT_THAT(error, HasSubstr(file.filename().string()));
    EXPECT_NE(row.at("words"), "") << file;
    for (const std::string& word : words(row.at("words"), ';'))
        EXPECT_THAT(error, HasSubstr(word));
}

void expect_loaded(const fs::path& file, const std::map<std::string, std::string>& row) {
    const LogCapture log;
    const Scene scene = import_gltf(file);
    EXPECT_EQ(problem_of(scene), "") << file.string();
    EXPECT_EQ(counts_of(scene), counts_in(row)) << file;
    const std::vector<std::string> warnings = words(row.at("words"), ';');
    EXPECT_EQ(static_cast<std::size_t>(log.lines()), warnings.size()) << log.text();
    EXPECT_EQ(row.at("result"), warnings.empty() ? "load" : "warn") << file;
    for (const std::string& warning : warnings)
        EXPECT_THAT(log.text(), HasSubstr(warning));
}

TEST(GltfCorpus, EveryFileDoesWhatTheTableSays) {
    const fs::path folder = corpus("GltfCorpus.EveryFileDoesWhatTheTableSays: 306 files");
    if (folder.empty()) return;
    const Table table = expected_table();
    EXPECT_EQ(table.size(), 306u);
    const std::vector<fs::path> files = gltf_files(folder);
    EXPECT_EQ(files.size(), table.size());
    for (const fs::path& file : files) {
        const auto row = table.find(fs::relative(file, folder).generic_string());
        ASSERT_NE(row, table.end()) << file << " is not in the table";
        try {
            if (row->second.at("result") == "refuse")
                expect_refusal(file, row->second);
            else
                expect_loaded(file, row->second);
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }
}

TEST(GltfCorpus, TheTableAgreesWithTheCorpus) {
    const fs::path folder = corpus("GltfCorpus.TheTableAgreesWithTheCorpus: its manifest");
    if (folder.empty()) return;
    const Table manifest = read_table(folder / "MANIFEST.csv");
    ASSERT_GT(manifest.size(), 100u);
    for (const auto& [file, row] : expected_table()) {
        const std::string group = words(file, '/').front();
        const bool loads = row.at("result") != "refuse";
        const bool explained = !row.at("note").empty();
        const bool sound = group != "malformed" && group != "unsupported";
        EXPECT_TRUE(!sound || loads || explained) << file;
        const auto facts = manifest.find(file);
        if (facts == manifest.end() || !loads) continue;
        const auto& [path, cells] = *facts;
        EXPECT_EQ(row.at("triangles"), cells.at("triangles")) << file;
        EXPECT_EQ(row.at("skins"), cells.at("skins")) << file;
        EXPECT_EQ(row.at("clips"), cells.at("animations")) << file;
        // Primitives of the same accessors become one mesh.
        EXPECT_EQ(row.at("meshes") != cells.at("primitives"), explained) << file;
        EXPECT_LE(std::stoul(row.at("meshes")), std::stoul(cells.at("primitives"))) << file;
    }
}

TEST(GltfCorpus, TheFormsOfTheBoxAreEqualToTheBit) {
    const fs::path folder = corpus("GltfCorpus.TheFormsOfTheBoxAreEqualToTheBit: 4 files");
    if (folder.empty()) return;
    const fs::path models = folder / "models";
    const Scene box = import_gltf(models / "Box/glTF/Box.gltf");
    ASSERT_EQ(box.meshes.size(), 1u);
    ASSERT_EQ(box.meshes[0].positions.size(), 24u);
    ASSERT_EQ(box.meshes[0].indices.size(), 36u);
    for (const char* form : {"Box/glTF-Binary/Box.glb", "Box/glTF-Embedded/Box.gltf"}) {
        const Scene other = import_gltf(models / form);
        EXPECT_EQ(other.meshes[0].positions, box.meshes[0].positions) << form;
        EXPECT_EQ(other.meshes[0].normals, box.meshes[0].normals) << form;
        EXPECT_EQ(other.meshes[0].indices, box.meshes[0].indices) << form;
        ASSERT_EQ(other.nodes.size(), box.nodes.size()) << form;
        EXPECT_EQ(matrix(other.nodes[0].local), matrix(box.nodes[0].local)) << form;
        EXPECT_EQ(other.materials[0].base_colour, box.materials[0].base_colour) << form;
    }
    // The interleaved box lists its vertices in the same order.
    const Scene interleaved = import_gltf(models / "BoxInterleaved/glTF/BoxInterleaved.gltf");
    EXPECT_EQ(interleaved.meshes[0].positions, box.meshes[0].positions);
    EXPECT_EQ(interleaved.meshes[0].normals, box.meshes[0].normals);
    EXPECT_EQ(interleaved.meshes[0].indices, box.meshes[0].indices);
}

TEST(GltfCorpus, TheDefaultSceneIsShown) {
    const fs::path folder = corpus("GltfCorpus.TheDefaultSceneIsShown: 1 file");
    if (folder.empty()) return;
    const Scene scenes = import_gltf(folder / "models/MultipleScenes/glTF/MultipleScenes.gltf");
    EXPECT_EQ(scenes.roots, std::vector<std::uint32_t>{1});
}

/// The file's tangents come from another program: they say which way w points in glTF.
TEST(GltfCorpus, ComputedTangentsAgreeWithThoseInTheFile) {
    const fs::path folder = corpus("GltfCorpus.ComputedTangentsAgreeWithThoseInTheFile: 1 file");
    if (folder.empty()) return;
    const Scene scene = import_gltf(folder / "models/FlightHelmet/glTF-512px/FlightHelmet.gltf");
    std::size_t same_direction = 0;
    std::size_t same_sign = 0;
    std::size_t total = 0;
    for (const Mesh& mesh : scene.meshes) {
        Mesh computed = mesh;
        compute_tangents(computed);
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const glm::vec4 theirs = mesh.tangents[mesh.indices[i]];
            const glm::vec4 ours = computed.tangents[computed.indices[i]];
            constexpr float k_cos_15_degrees = 0.966f;
            same_direction += glm::dot(glm::vec3{ours}, glm::vec3{theirs}) > k_cos_15_degrees ? 1 : 0;
            same_sign += ours.w == theirs.w ? 1 : 0;
            ++total;
        }
    }
    // The weights differ where many triangles meet, and seams were merged by the exporter.
    EXPECT_GT(static_cast<double>(same_direction), 0.95 * static_cast<double>(total));
    EXPECT_GT(static_cast<double>(same_sign), 0.99 * static_cast<double>(total));
}

}  // namespace
}  // namespace rambla::assets::test
