#include "game/inspect_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "game/pass_table.h"

namespace rambla::game {
namespace {

using Json = nlohmann::json;

/// More rows than these fill screens; --json has them all.
constexpr std::size_t k_most_rows = 40;
/// A cell that would be longer ends in "...".
constexpr std::size_t k_widest_cell = 48;

/// Names come from untrusted files: control characters would play with the terminal.
std::string printable(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return text;
}

std::string text_of(const Json& value) {
    if (value.is_null() || value.empty()) return "-";
    if (value == "") return "-";
    if (value.is_string()) return printable(value.get<std::string>());
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "-";
    if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
    if (value.is_array()) {
        std::string text;
        for (const Json& element : value)
            text.append(text.empty() ? "" : " ").append(text_of(element));
        return text;
    }
    return value.dump();
}

struct Column {
    const char* heading;
    const char* key;                                    ///< of the row's member to show
    std::string (*cell)(const Json& member) = text_of;  ///< what it is shown as
};

struct Table {
    const char* key;  ///< of the array, and the table's title
    std::vector<Column> columns;
    std::size_t most_rows = k_most_rows;
    std::size_t widest_cell = k_widest_cell;
};

std::string bytes_cell(const Json& bytes) {
    if (bytes.is_null()) return "-";
    return bytes_text(bytes.get<double>());
}

std::string count_cell(const Json& list) {
    return list.empty() ? "-" : std::to_string(list.size());
}

std::string bounds_cell(const Json& bounds) {
    if (bounds.is_null()) return "-";
    return fmt::format("{} .. {}", text_of(bounds["min"]), text_of(bounds["max"]));
}

/// mesh/material of each part
std::string parts_cell(const Json& parts) {
    std::string text;
    for (const Json& part : parts)
        text +=
            fmt::format("{}{}/{}", text.empty() ? "" : " ", text_of(part["mesh"]), text_of(part["material"]));
    return text.empty() ? "-" : text;
}

std::string uses_cell(const Json& textures) {
    std::string text;
    for (const auto& [use, slot] : textures.items())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", use, text_of(slot["texture"]));
    return text.empty() ? "-" : text;
}

const std::vector<Table> k_tables{
    {"scenes", {{"", "index"}, {"name", "name"}, {"root nodes", "roots"}}},
    {"nodes",
     {{"", "index"},
      {"name", "name"},
      {"parent", "parent"},
      {"children", "children", count_cell},
      {"model", "model"},
      {"skeleton", "skeleton"},
      {"camera", "camera"},
      {"light", "light"},
      {"emitter", "emitter"},
      {"coarser", "coarser"},
      {"translation m", "translation_m"}}},
    {"models",
     {{"", "index"}, {"name", "name"}, {"mesh/material", "parts", parts_cell}, {"triangles", "triangles"}}},
    {"meshes",
     {{"", "index"},
      {"name", "name"},
      {"of", "topology"},
      {"elements", "elements"},
      {"vertices", "vertices"},
      {"attributes", "attributes"},
      {"morphs", "morph_targets", count_cell},
      {"bounds m", "bounds_m", bounds_cell},
      {"memory", "bytes", bytes_cell}}},
    {"materials",
     {{"", "index"},
      {"name", "name"},
      {"alpha", "alpha_mode"},
      {"two-sided", "double_sided"},
      {"unlit", "unlit"},
      {"metalness", "metalness"},
      {"roughness", "roughness"},
      {"textures", "textures", uses_cell},
      {"extensions", "extensions"}}},
    {"textures",
     {{"", "index"},
      {"name", "name"},
      {"image", "image"},
      {"colour space", "colour_space"},
      {"wrap", "wrap"},
      {"magnify", "magnify"},
      {"minify", "minify"},
      {"mip", "mip"}}},
    {"images",
     {{"", "index"},
      {"name", "name"},
      {"width", "width_px"},
      {"height", "height_px"},
      {"format", "format"},
      {"colour space", "colour_spaces"},
      {"encoding", "encoding"},
      {"from", "source"},
      {"stored", "encoded_bytes", bytes_cell},
      {"memory", "bytes", bytes_cell}}},
    {"skeletons", {{"", "index"}, {"name", "name"}, {"joints", "joint_count"}, {"names", "joint_names"}}},
    {"clips",
     {{"", "index"},
      {"name", "name"},
      {"seconds", "duration_s"},
      {"channels", "channels"},
      {"keys", "keys"},
      {"nodes", "nodes", count_cell},
      {"moves", "paths"},
      {"interpolation", "interpolations"}}},
    {"cameras",
     {{"", "index"},
      {"name", "name"},
      {"kind", "kind"},
      {"height deg", "vertical_fov_deg"},
      {"half width m", "half_width_m"},
      {"half height m", "half_height_m"},
      {"near m", "near_m"},
      {"far m", "far_m"}}},
    {"lights",
     {{"", "index"},
      {"name", "name"},
      {"kind", "kind"},
      {"colour", "colour"},
      {"intensity", "intensity"},
      {"range m", "range_m"},
      {"inner deg", "inner_cone_deg"},
      {"outer deg", "outer_cone_deg"}}},
    {"emitters",
     {{"", "index"},
      {"name", "name"},
      {"material", "material"},
      {"particles", "particles"},
      {"lifetime s", "lifetime_s"},
      {"spread m", "spread_m"},
      {"velocity m/s", "velocity_m_s"},
      {"+- m/s", "velocity_spread_m_s"},
      {"acceleration m/s2", "acceleration_m_s2"},
      {"from m", "start_radius_m"},
      {"to m", "end_radius_m"}}},
};

const Table k_files{"files",
                    {{"result", "result"},
                     {"meshes", "meshes"},
                     {"triangles", "triangles"},
                     {"skins", "skins"},
                     {"clips", "clips"},
                     {"materials", "materials"},
                     {"images", "images"},
                     {"memory", "memory_bytes", bytes_cell},
                     {"file", "file"},
                     {"words", "words"}},
                    std::numeric_limits<std::size_t>::max(),
                    std::numeric_limits<std::size_t>::max()};

bool starts_character(char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
}

/// Characters of UTF-8 text.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string cut(const std::string& text, std::size_t widest) {
    if (width_of(text) <= widest) return text;
    std::size_t end = 0;
    for (std::size_t characters = 0; characters + 3 < widest; ++characters)
        do
            ++end;
        while (!starts_character(text[end]));
    return text.substr(0, end) + "...";
}

std::string cell_text(const Json& row, const Column& column, std::size_t widest) {
    const auto member = row.find(column.key);
    return member == row.end() ? "-" : cut(column.cell(*member), widest);
}

/// Columns as wide as their widest cell; those in which no row says anything are left out.
std::string table_text(const Json& rows, const Table& table) {
    std::string text = fmt::format("\n{} ({})\n", table.key, rows.size());
    const std::size_t shown = std::min(rows.size(), table.most_rows);
    std::vector<std::string> lines(shown + 1, " ");
    for (const Column& column : table.columns) {
        std::vector<std::string> cells{column.heading};
        for (std::size_t i = 0; i < shown; ++i)
            cells.push_back(cell_text(rows[i], column, table.widest_cell));
        const bool speaks = std::any_of(cells.begin() + 1, cells.end(),
                                        [](const std::string& cell) { return !cell.empty() && cell != "-"; });
        if (!speaks) continue;
        std::size_t width = 0;
        for (const std::string& cell : cells)
            width = std::max(width, width_of(cell));
        for (std::size_t i = 0; i < cells.size(); ++i)
            lines[i].append(" ").append(cells[i]).append(width - width_of(cells[i]), ' ');
    }
    for (std::string& line : lines)
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (shown < rows.size())
        text += fmt::format("  ... and {} more: --json has them all\n", rows.size() - shown);
    return text;
}

std::string gltf_text(const Json& inspection) {
    const Json& totals = inspection["totals"];
    std::string text =
        fmt::format("{}\nglTF {}\n", text_of(inspection["file"]), text_of(inspection["version"]));
    const auto line = [&](const char* what, const std::string& value) {
        text += fmt::format("{:<22} {}\n", what, value);
    };
    line("made by", text_of(inspection["generator"]));
    line("extensions used", text_of(inspection["extensions_used"]));
    line("extensions required", text_of(inspection["extensions_required"]));
    if (!inspection["extensions_ignored"].empty())
        line("extensions ignored", text_of(inspection["extensions_ignored"]));
    line("triangles of all nodes", text_of(totals["triangles_of_all_nodes"]));
    line("file", bytes_cell(totals["document_bytes"]));
    line("buffers", bytes_cell(totals["buffer_bytes"]));
    line("pictures", bytes_cell(totals["encoded_image_bytes"]));
    line("memory", fmt::format("{} (meshes {}, images {}, clips {})", bytes_cell(totals["memory_bytes"]),
                               bytes_cell(totals["mesh_bytes"]), bytes_cell(totals["image_bytes"]),
                               bytes_cell(totals["clip_bytes"])));
    for (const Table& table : k_tables)
        if (const Json& rows = inspection[table.key]; !rows.empty()) text += table_text(rows, table);
    const Json& warnings = inspection["warnings"];
    if (!warnings.empty()) text += fmt::format("\nwarnings ({})\n", warnings.size());
    for (const Json& warning : warnings)
        text += fmt::format("  {}\n", text_of(warning));
    return text;
}

std::string picture_text(const Json& inspection) {
    return fmt::format(
        "{}\npicture     {}\nsize        {} x {}\nchannels    {}, {}\nstored      {}\nmemory      {} as {}\n",
        text_of(inspection["file"]), text_of(inspection["encoding"]), text_of(inspection["width_px"]),
        text_of(inspection["height_px"]), text_of(inspection["channels"]), text_of(inspection["sample"]),
        bytes_cell(inspection["file_bytes"]), bytes_cell(inspection["bytes"]), text_of(inspection["format"]));
}

}  // namespace

std::string inspection_text(const Json& inspection) {
    return inspection["kind"] == "picture" ? picture_text(inspection) : gltf_text(inspection);
}

std::string files_text(const Json& files) {
    const Json& rows = files["files"];
    const auto count = [&](const char* result) {
        return std::count_if(rows.begin(), rows.end(),
                             [&](const Json& row) { return row["result"] == result; });
    };
    return table_text(rows, k_files) + fmt::format("\n{} load, {} load with warnings, {} are refused\n",
                                                   count("load"), count("warn"), count("refuse"));
}

}  // namespace rambla::game
