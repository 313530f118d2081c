#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> k_rooms{"ecs", "assets", "systems", "render", "game"};

/// What each room may include of the others: folders, or single headers.
const std::map<std::string, std::vector<std::string>> k_may_include{
    {"ecs", {}},
    {"assets", {}},
    {"systems", {"ecs/", "assets/"}},
    {"render", {"assets/", "systems/frame.h", "systems/feedback.h", "systems/look/cull_kernel.h"}},
    {"game", {"ecs/", "assets/", "systems/", "render/"}},
};

/// Rooms that see only the data types of assets: the headers in its top folder, not those that read, make or
/// write.
const std::set<std::string> k_data_types_only{"systems", "render"};

/// Libraries that only the named folders may include, by the beginning of the include path.
const std::map<std::string, std::vector<std::string>> k_library_homes{
    {"tiny_gltf.h", {"assets/import/", "assets/export/"}},
    {"OpenImageIO/", {"assets/import/", "assets/export/"}},
    {"meshoptimizer.h", {"assets/process/"}},
    {"squish.h", {"assets/process/"}},
    {"xxhash.h", {"assets/cache/"}},
    {"embree", {"assets/trace/"}},
    {"epoxy/", {"render/", "game/"}},
    {"GL/", {}},
    {"EGL/", {"render/gl/"}},
    {"GLFW/", {"game/"}},
    {"imgui.h", {"render/post/", "game/"}},
    {"imgui_internal.h", {}},
    {"backends/imgui_impl_opengl3.h", {"render/post/"}},
    {"backends/imgui_impl_glfw.h", {"game/"}},
    {"CLI/", {"game/"}},
    {"glm/", {"assets/", "systems/", "render/", "game/"}},
    {"spdlog/", {"assets/", "systems/", "render/", "game/"}},
    {"nlohmann/", {"assets/", "game/"}},
    {"tbb/", {"ecs/", "assets/", "systems/", "game/"}},
    {"oneapi/", {"ecs/", "assets/", "systems/", "game/"}},
};

bool starts_with(const std::string& text, const std::string& beginning) {
    return text.rfind(beginning, 0) == 0;
}

bool any_start(const std::string& text, const std::vector<std::string>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const auto& b) { return starts_with(text, b); });
}

struct Include {
    std::string path;
    bool quoted = false;
};

std::vector<Include> includes_of(const std::string& text) {
    static const std::regex pattern{R"(^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">])",
                                    std::regex::multiline};
    std::vector<Include> found;
    for (std::sregex_iterator i{text.begin(), text.end(), pattern}, end; i != end; ++i) {
        found.push_back({(*i)[2].str(), (*i)[1].str() == "\""});
    }
    return found;
}

/// Every include of `file` (a path from the source folder) that crosses a wall, as one line each.
std::vector<std::string> crossings(const std::string& file, const std::string& text) {
    const std::string room = file.substr(0, file.find('/'));
    std::vector<std::string> found;
    for (const Include& include : includes_of(text)) {
        if (include.path.find("..") != std::string::npos)
            found.push_back(file + ": climbs out: " + include.path);
        const std::string other = include.path.substr(0, include.path.find('/'));
        const bool ours = std::find(k_rooms.begin(), k_rooms.end(), other) != k_rooms.end();
        if (ours && other != room && !any_start(include.path, k_may_include.at(room))) {
            found.push_back(file + ": " + room + " may not include " + include.path);
        }
        const bool deeper = std::count(include.path.begin(), include.path.end(), '/') > 1;
        if (other == "assets" && deeper && k_data_types_only.count(room) != 0) {
            found.push_back(file + ": " + room + " may include data types of assets only, not " +
                            include.path);
        }
        for (const auto& [library, homes] : k_library_homes) {
            if (!ours && starts_with(include.path, library) && !any_start(file, homes)) {
                found.push_back(file + ": " + include.path + " is not for this folder");
            }
        }
    }
    return found;
}

std::string read(const fs::path& file) {
    std::ifstream stream{file};
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(IncludeWalls, NoSourceIncludesAcrossAForbiddenEdge) {
    const fs::path root{RAMBLA_SOURCE_DIR};
    std::size_t files = 0;
    for (const std::string& room : k_rooms) {
        for (const auto& entry : fs::recursive_directory_iterator{root / room}) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp") continue;
            ++files;
            for (const std::string& crossing :
                 crossings(fs::relative(entry.path(), root).string(), read(entry.path()))) {
                ADD_FAILURE() << crossing;
            }
        }
    }
    EXPECT_GT(files, 60u) << "the rooms were not found under " << root;
}

TEST(IncludeWalls, TheCheckSeesEachKindOfCrossing) {
    EXPECT_EQ(crossings("assets/mesh.h", "#include \"ecs/world.h\"\n").size(), 1u);
    EXPECT_EQ(crossings("render/passes/sky.cpp", "#include \"systems/components.h\"\n").size(), 1u);
    EXPECT_EQ(crossings("systems/frame.h", "# include <epoxy/gl.h>\n").size(), 1u);
    EXPECT_EQ(crossings("render/renderer.cpp", "#include \"../systems/spawn.h\"\n").size(), 1u);
    EXPECT_EQ(crossings("game/app.cpp", "#include <tiny_gltf.h>\n").size(), 1u);
    EXPECT_EQ(crossings("assets/import/gltf_mesh.cpp", "#include <meshoptimizer.h>\n").size(), 1u);
    EXPECT_EQ(crossings("assets/cache/cache.cpp", "#include <squish.h>\n").size(), 1u);
    EXPECT_EQ(crossings("assets/process/compress.cpp", "#include <squish.h>\n").size(), 0u);
    EXPECT_EQ(crossings("systems/spawn.cpp", "#include \"assets/import/gltf.h\"\n").size(), 1u);
    EXPECT_EQ(
        crossings("render/renderer.cpp", "#include \"systems/frame.h\"\n#include <epoxy/gl.h>\n").size(), 0u);
}

}  // namespace
