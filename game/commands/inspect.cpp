#include <CLI/Option.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "assets/error.h"
#include "assets/export/image.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/inspect_csv.h"
#include "game/inspect_file.h"
#include "game/inspect_text.h"
#include "game/json_output.h"
#include "game/options.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

struct InspectCommand {
    Options options;
    std::vector<fs::path> files;
    fs::path csv;
};

/// The inspection of one file; a script that asked for JSON gets some for a refused one, too.
nlohmann::json inspection_of(const fs::path& file, const std::string& json) {
    try {
        return inspect_file(file);
    } catch (const assets::Error& error) {
        write_json(json, {{"schema", "rambla.inspect/1"}, {"file", file.string()}, {"error", error.what()}});
        throw;
    }
}

bool all_refused(const nlohmann::json& files) {
    return std::all_of(files.begin(), files.end(),
                       [](const nlohmann::json& row) { return row["result"] == "refuse"; });
}

int run(const InspectCommand& command) {
    prepare_json(command.options.json);
    const bool several = command.files.size() > 1;
    const nlohmann::json result =
        several ? inspect_files(command.files) : inspection_of(command.files[0], command.options.json);
    print_result(command.options.json, several ? files_text(result) : inspection_text(result));
    if (!command.csv.empty())
        assets::write_text(command.csv, files_csv(several ? result : inspect_files(command.files)));
    write_json(command.options.json, result);
    return several && all_refused(result["files"]) ? k_bad_input : k_done;
}

}  // namespace

Command add_inspect(CLI::App& program) {
    CLI::App* const line =
        program.add_subcommand("inspect", "Tells what a glTF or picture file holds, and what it costs");
    const auto command = std::make_shared<InspectCommand>();
    line->footer(
        "Names ending in .gltf or .glb are glTF; everything else is a picture (PNG, JPEG, HDR, EXR, TIFF, "
        "TGA, "
        "DDS),\n"
        "known by its content. --json has every row of every table, and more of each.\n"
        "Of several files there is one table with a row for each, which says whether it loads, loads with "
        "warnings, or is\n"
        "refused and why; if all are refused, the exit code is 2, as for a single one.\n");
    line->add_option("files", command->files, "File to look into; several: a table of them")
        ->type_name("FILE")
        ->required();
    line->add_option("--csv", command->csv, "Writes the table of files, comma-separated")->type_name("FILE");
    add_message_options(*line, command->options);
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
