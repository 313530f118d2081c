#include "game/inspect_file.h"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "assets/error.h"
#include "assets/import/gltf_facts.h"
#include "assets/import/image.h"
#include "game/inspect_json.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class WarningSink final : public spdlog::sinks::base_sink<std::mutex> {
public:
    std::vector<std::string> lines;

private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        lines.emplace_back(message.payload.data(), message.payload.size());
    }
    void flush_() override {}
};

/// Calls `work`; what it logs goes into the list instead, because it is part of the result.
template <class Work>
auto with_warnings(std::vector<std::string>& warnings, Work&& work) {
    struct Redirection {
        std::shared_ptr<spdlog::logger> previous = spdlog::default_logger();
        std::shared_ptr<WarningSink> sink = std::make_shared<WarningSink>();
        Redirection() { spdlog::set_default_logger(std::make_shared<spdlog::logger>("inspect", sink)); }
        ~Redirection() { spdlog::set_default_logger(previous); }
    };
    const Redirection redirection;
    auto result = work();
    warnings = redirection.sink->lines;
    return result;
}

bool is_gltf(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
    return extension == ".gltf" || extension == ".glb";
}

std::string joined(const Json& lines) {
    std::string text;
    for (const Json& line : lines)
        text += (text.empty() ? "" : "; ") + line.get<std::string>();
    return text;
}

/// @param inspection  of a glTF file
void add_counts(Json& row, const Json& inspection) {
    std::uint64_t triangles = 0;
    for (const Json& model : inspection["models"])
        triangles += model["triangles"].get<std::uint64_t>();
    row["meshes"] = inspection["meshes"].size();
    row["triangles"] = triangles;
    row["skins"] = inspection["skeletons"].size();
    row["clips"] = inspection["clips"].size();
    for (const char* const list : {"nodes", "materials", "images", "cameras", "lights"})
        row[list] = inspection[list].size();
    row["memory_bytes"] = inspection["totals"]["memory_bytes"];
    row["result"] = inspection["warnings"].empty() ? "load" : "warn";
    row["words"] = joined(inspection["warnings"]);
}

Json row_of(const fs::path& file) {
    Json row{{"file", file.string()}, {"result", "load"}, {"words", ""}};
    for (const char* const count : {"meshes", "triangles", "skins", "clips", "nodes", "materials", "images",
                                    "cameras", "lights", "memory_bytes"})
        row[count] = nullptr;
    try {
        const Json inspection = inspect_file(file);
        if (inspection["kind"] == "glTF") add_counts(row, inspection);
    } catch (const assets::Error& error) {
        row["result"] = "refuse";
        row["words"] = error.what();
    }
    return row;
}

}  // namespace

Json inspect_file(const fs::path& file) {
    if (is_gltf(file)) {
        std::vector<std::string> warnings;
        const assets::GltfWithFacts gltf =
            with_warnings(warnings, [&] { return assets::import_gltf_with_facts(file); });
        return inspection(file, gltf, warnings);
    }
    return inspection(file, assets::read_image_with_facts(file));
}

Json inspect_files(std::span<const fs::path> files) {
    Json rows = Json::array();
    for (const fs::path& file : files)
        rows.push_back(row_of(file));
    return {{"schema", "rambla.inspect_files/1"}, {"files", rows}};
}

}  // namespace rambla::game
