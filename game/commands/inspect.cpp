#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <CLI/Option.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "assets/import/gltf_facts.h"
#include "assets/import/image.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/inspect_json.h"
#include "game/inspect_text.h"
#include "game/json_output.h"
#include "game/options.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

struct InspectCommand {
    Options options;
    fs::path file;
};

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

nlohmann::json inspect(const fs::path& file) {
    if (is_gltf(file)) {
        std::vector<std::string> warnings;
        const assets::GltfWithFacts gltf =
            with_warnings(warnings, [&] { return assets::import_gltf_with_facts(file); });
        return inspection(file, gltf, warnings);
    }
    return inspection(file, assets::read_image_with_facts(file));
}

int run(const InspectCommand& command) {
    prepare_json(command.options.json);
    const nlohmann::json result = inspect(command.file);
    print_result(command.options.json, inspection_text(result));
    write_json(command.options.json, result);
    return k_done;
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
        "known by its content. --json has every row of every table, and more of each.\n");
    line->add_option("file", command->file, "File to look into")->type_name("FILE")->required();
    add_message_options(*line, command->options);
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
