#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "assets/export/image.h"
#include "assets/import/gltf.h"
#include "game/app.h"
#include "game/clips.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/framing.h"
#include "game/json_output.h"
#include "game/options.h"
#include "game/scene_cache.h"
#include "game/view_session.h"
#include "game/window.h"
#include "render/render_thread.h"
#include "systems/components.h"
#include "systems/position.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

constexpr float k_fov_rad = 0.7f;  // 40°: models look natural, neither flat nor bulging

struct ViewCommand {
    Options options;
    fs::path file;
    fs::path out;
    std::optional<std::uint32_t> camera;
    std::uint64_t frames = 0;
    std::string clip;
    double clip_time_s = 0.0;
    const CLI::Option* clip_given = nullptr;
    const CLI::Option* clip_time_given = nullptr;
    const CLI::Option* shadows = nullptr;
};

/// The file's camera that was asked for, else its first, else a view of everything.
systems::Eye first_eye(const ViewCommand& command, const assets::Scene& scene, const assets::Bounds& box) {
    const std::uint32_t index = command.camera.value_or(0);
    if (std::optional<systems::Eye> eye = scene_camera(scene, index, command.options.origin)) return *eye;
    if (command.camera) {
        std::uint32_t count = 0;
        while (scene_camera(scene, count, command.options.origin))
            ++count;
        throw std::invalid_argument{fmt::format(
            "--camera is {}, but {} has {}", index, command.file.string(),
            count == 0 ? "none" : fmt::format("only {}, counted from 0, in its default scene", count))};
    }
    const glm::vec2 size{command.options.size_px};
    systems::Eye eye = eye_of(frame_bounds(box, k_fov_rad, size.x / size.y), command.options.origin);
    eye.vertical_fov_rad = k_fov_rad;
    return eye;
}

/// Shadows reach as far as the model does, whatever its scale, unless the user has said how far.
render::Settings settings_for(const ViewCommand& command, const systems::Eye& eye, const assets::Bounds& box,
                              float exposure_ev) {
    render::Settings settings = command.options.settings_at(exposure_ev);
    if (command.shadows->count() > 0 || box.empty()) return settings;
    const glm::vec3 to_centre = systems::offset_m(eye.place, command.options.origin) + box.centre();
    settings.shadows.distance_m = glm::length(to_centre) + glm::length(box.half_extents());
    return settings;
}

/// The clip that the user asked for; else, where something shall move, the first.
std::optional<std::uint32_t> chosen_clip(const ViewCommand& command, const Stage& stage, bool moves) {
    const assets::Scene& scene = *stage.scene;
    if (command.clip_given->count() > 0) {
        const std::uint32_t clip = find_clip(scene, command.clip, command.file.string());
        if (stage.player != ecs::Entity{}) return clip;
        throw std::invalid_argument{
            fmt::format("--clip is '{}', but nothing that it moves is in the default scene of {}",
                        command.clip, command.file.string())};
    }
    if (stage.player != ecs::Entity{} && (moves || command.clip_time_given->count() > 0)) return 0;
    if (command.clip_time_given->count() == 0) return {};
    throw std::invalid_argument{
        fmt::format("--clip-time is {} s, but {} has no clips", command.clip_time_s, command.file.string())};
}

/// What plays, for the results.
void add_clip(nlohmann::json& json, const Stage& stage) {
    json["clips"] = stage.scene->clips.size();
    json["clip"] = nullptr;
    json["clip_time_s"] = nullptr;
    if (stage.player == ecs::Entity{}) return;
    const systems::ClipCursor& playing = stage.world->get<systems::AnimationPlayer>(stage.player).playing;
    if (playing.clip == assets::k_none) return;
    json["clip"] = clip_label(*stage.scene, playing.clip);
    json["clip_time_s"] = playing.time_s;
}

int draw_picture(const ViewCommand& command, Stage& stage, systems::Eye eye,
                 const render::Settings& settings) {
    const bool linear = command.out.extension() == ".exr";
    eye.size_px = command.options.size_px;
    render::RenderThread thread{{.window = {}, .shaders = {}, .gl_errors_throw = false}};
    thread.upload(stage.scene, prepare_scene(*stage.scene, thread.device(), command.options.quiet).scene);
    render::FrameInput& input = thread.begin();
    systems::build_frame(*stage.world, eye, 1.0f, input.frame);
    input.frame.capture = {.display = !linear, .linear = linear};
    input.settings = settings;
    const systems::FrameCounts counts = input.frame.counts;
    thread.submit();
    thread.finish();
    const std::vector<render::FrameOutput> outputs = thread.collect();
    const std::optional<assets::Image>& picture = linear ? outputs.at(0).linear : outputs.at(0).display;
    if (command.out.has_parent_path()) fs::create_directories(command.out.parent_path());
    assets::write_image(command.out, picture.value());
    nlohmann::json json{{"schema", "rambla.view/1"},
                        {"file", command.file.string()},
                        {"out", command.out.string()},
                        {"entities", stage.world->entity_count()},
                        {"visible", counts.visible},
                        {"lights", counts.lights},
                        {"draws", outputs.at(0).feedback.draws},
                        {"triangles", outputs.at(0).feedback.triangles}};
    add_clip(json, stage);
    write_json(command.options.json, json);
    spdlog::info("Wrote {}", command.out.string());
    return k_done;
}

int show_window(const ViewCommand& command, Stage& stage, const systems::Eye& eye, const assets::Bounds& box,
                const render::Settings& settings) {
    ViewSession session{stage, eye, box};
    const std::uint64_t frames =
        run_app({.title = "Rambla: " + command.file.filename().string(),
                 .size_px = command.options.size_px,
                 .walking = false,
                 .quiet = command.options.quiet,
                 .frames = command.frames},
                stage, settings, [&session](const Moment& moment) { return session.update(moment); });
    nlohmann::json json{{"schema", "rambla.view/1"}, {"file", command.file.string()}, {"frames", frames}};
    add_clip(json, stage);
    write_json(command.options.json, json);
    return k_done;
}

/// For CLI11: what is wrong with a number, if anything.
std::string finite_number(const std::string& text) {
    try {
        if (std::isfinite(std::stod(text))) return {};
    } catch (const std::exception&) {
        // no number at all
    }
    return fmt::format("found '{}', expected a finite number of seconds", text);
}

int run(ViewCommand& command) {
    prepare_json(command.options.json);
    const tbb::global_control limit = worker_limit(command.options);
    const bool windowed = !command.options.headless && command.out.empty() && has_display();
    if (command.out.empty()) command.out = fs::path{"out"} / command.file.stem().concat(".png");
    const std::string extension = command.out.extension().string();
    if (extension != ".png" && extension != ".exr") {
        throw std::invalid_argument{
            fmt::format("--out is '{}', expected a name that ends in .png or .exr", command.out.string())};
    }
    assets::Scene scene = assets::import_gltf(command.file);
    const ViewingLight light = viewing_light(scene, command.options.time);
    if (light.own && command.options.time != assets::TimeOfDay{}) {
        throw std::invalid_argument{fmt::format("--time is {}, but {} brings its own light",
                                                to_text(command.options.time), command.file.string())};
    }
    Stage stage = make_stage(std::move(scene), light.environment, command.options.origin);
    const std::optional<std::uint32_t> clip = chosen_clip(command, stage, windowed);
    const assets::Bounds box = clip_bounds(stage, clip);
    if (clip) show_clip(stage, *clip, command.clip_time_s);
    const systems::Eye eye = first_eye(command, *stage.scene, box);
    const render::Settings settings = settings_for(command, eye, box, light.exposure_ev);
    return windowed ? show_window(command, stage, eye, box, settings)
                    : draw_picture(command, stage, eye, settings);
}

}  // namespace

Command add_view(CLI::App& program) {
    CLI::App* const line = program.add_subcommand("view", "Shows a glTF file, in a window or as a picture");
    const auto command = std::make_shared<ViewCommand>();
    Options& options = command->options;
    line->footer(
        "Looks through the file's first camera, or shows everything if it has none. The light is the file's "
        "own with a\n"
        "soft sky; a file without lights stands in the noon sun, or in the light of --time.\n"
        "Opens a window where there is a display, unless --headless or --out is given. In the window the "
        "left button\n"
        "turns around the model, the wheel comes nearer; F1 shows the keys. The first clip plays there, or "
        "that "
        "of --clip;\n"
        "a picture shows the file's own pose unless --clip or --clip-time is given.\n");
    line->add_option("file", command->file, "File to show")->type_name("FILE.glb|FILE.gltf")->required();
    CLI::Option* const out =
        line->add_option("-o,--out", command->out,
                         "Picture to write: .png as a screen shows it, .exr linear light")
            ->type_name("FILE");
    CLI::Option* const headless = line->add_flag("--headless", options.headless,
                                                 "Draws without a window; into out/ unless --out says where");
    line->add_option("--camera", command->camera, "Looks through the file's camera number N, from 0")
        ->type_name("N")
        ->transform(whole_number(0, std::numeric_limits<std::uint32_t>::max()));
    command->clip_given =
        line->add_option("--clip", command->clip,
                         "Shows the clip of that name, or of that number, from 0 (rambla inspect lists them)")
            ->type_name("NAME");
    command->clip_time_given =
        line->add_option("--clip-time", command->clip_time_s,
                         "Shows the clip (default: the first) at that time; beyond its ends it starts over")
            ->type_name("S")
            ->check(CLI::Validator{finite_number, "", "a finite number"});
    line->add_option("--frames", command->frames, "Window only: closes it after so many pictures")
        ->type_name("N")
        ->transform(whole_number())
        ->excludes(headless)
        ->excludes(out);
    add_time_option(*line, options);
    add_place_options(*line, options);
    add_picture_options(*line, options);
    add_message_options(*line, options);
    command->shadows = line->get_option("--shadows");
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
