#include <spdlog/spdlog.h>

#include <CLI/Option.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "assets/export/gltf.h"
#include "assets/export/sun.h"
#include "assets/generate/places.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/json_output.h"
#include "game/options.h"

namespace rambla::game {
namespace {

struct GenerateCommand {
    Options options;
    std::filesystem::path out;
};

int run(const GenerateCommand& command) {
    prepare_json(command.options.json);
    assets::Place place =
        assets::generate_place(command.options.scene, command.options.seed, command.options.time);
    assets::add_sun(place.scene, place.environment);
    assets::export_gltf(command.out, place.scene);
    write_json(command.options.json, {{"schema", "rambla.generate/1"},
                                      {"scene", command.options.scene},
                                      {"seed", command.options.seed},
                                      {"time", to_text(command.options.time)},
                                      {"out", command.out.string()},
                                      {"nodes", place.scene.nodes.size()},
                                      {"meshes", place.scene.meshes.size()},
                                      {"materials", place.scene.materials.size()},
                                      {"images", place.scene.images.size()}});
    spdlog::info("Wrote {} ({} nodes, {} meshes, {} materials, {} images)", command.out.string(),
                 place.scene.nodes.size(), place.scene.meshes.size(), place.scene.materials.size(),
                 place.scene.images.size());
    return k_done;
}

}  // namespace

Command add_generate(CLI::App& program) {
    CLI::App* const line = program.add_subcommand("generate", "Writes a generated scene as a glTF file");
    const auto command = std::make_shared<GenerateCommand>();
    line->add_option("scene", command->options.scene,
                     "What is generated, with its parameters: city:blocks=2x2, blocks, agents")
        ->type_name("SCENE")
        ->required();
    line->add_option("--seed", command->options.seed, "Chooses among the places that the scene describes")
        ->type_name("N")
        ->transform(whole_number())
        ->capture_default_str();
    add_time_option(*line, command->options);
    line->add_option("-o,--out", command->out, "File to write")->type_name("FILE.glb")->required();
    add_message_options(*line, command->options);
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
