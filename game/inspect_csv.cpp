#include "game/inspect_csv.h"

#include <array>
#include <nlohmann/json.hpp>

namespace rambla::game {
namespace {

using Json = nlohmann::json;

std::string csv_cell(const Json& value) {
    if (value.is_null()) return {};
    if (!value.is_string()) return value.dump();
    const std::string text = value.get<std::string>();
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted.append(c == '"' ? 2 : 1, c);
    return quoted + "\"";
}

}  // namespace

std::string files_csv(const Json& files) {
    constexpr std::array k_columns{"file",   "result",       "meshes",    "triangles", "skins",
                                   "clips",  "nodes",        "materials", "images",    "cameras",
                                   "lights", "memory_bytes", "words"};
    std::string text;
    for (const char* const column : k_columns)
        text.append(text.empty() ? "" : ",").append(column);
    text += "\n";
    for (const Json& row : files["files"]) {
        std::string line;
        for (const char* const column : k_columns)
            line.append(line.empty() ? "" : ",").append(csv_cell(row[column]));
        text += line + "\n";
    }
    return text;
}

}  // namespace rambla::game
